package sunbeam.precompute.json;

import sunbeam.precompute.text.Quoted;

/** Reports a JSON file that cannot be used; the message, always one line, names the file, the line, the key and the remedy. */
public final class JsonException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public JsonException(String message) {
        super(Quoted.oneLine(message));
    }

    public JsonException(String message, Throwable cause) {
        super(Quoted.oneLine(message), cause);
    }
}
