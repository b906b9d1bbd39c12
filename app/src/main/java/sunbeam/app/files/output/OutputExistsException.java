package sunbeam.app.files.output;

/** An output file that is there already and may not be replaced; the message names the file and the remedy. */
public final class OutputExistsException extends OutputException {
    public OutputExistsException(String message) {
        super(message);
    }

    OutputExistsException(String message, Throwable cause) {
        super(message, cause);
    }
}
