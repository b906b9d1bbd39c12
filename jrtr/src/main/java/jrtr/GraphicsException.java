package jrtr;

/**
 * Thrown if the machine, its driver or a shader cannot do something. The message is one line that names the object, the value
 * and, where there is one, the remedy.
 */
public class GraphicsException extends RuntimeException {
    public GraphicsException(String message) {
        this(message, null);
    }

    /** @param message what failed and how to mend it; line breaks are replaced by spaces */
    public GraphicsException(String message, Throwable cause) {
        super(message.strip().replaceAll("\\s*\\R\\s*", " "), cause);
    }
}
