package jrtr;

/** Failure of the machine, its driver or a shader; the message is one line that names object, value and remedy. */
public class GraphicsException extends RuntimeException {
    public GraphicsException(String message) {
        this(message, null);
    }

    /** @param message what failed and how to mend it; line breaks are replaced by spaces */
    public GraphicsException(String message, Throwable cause) {
        super(message.strip().replaceAll("\\s*\\R\\s*", " "), cause);
    }
}
