package sunbeam.app.files.output;

/** Thrown if an output file exists and may not be replaced; the message names the file and the remedy. */
public final class OutputExistsException extends OutputException {
    public OutputExistsException(String message) {
        super(message);
    }

    OutputExistsException(String message, Throwable cause) {
        super(message, cause);
    }
}
