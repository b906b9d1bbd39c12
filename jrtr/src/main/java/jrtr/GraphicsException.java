package jrtr;

/**
 * Thrown if the machine, its driver or a shader cannot do something. The message is one line that names the object, the value
 * and, where there is one, the remedy.
 */
public class GraphicsException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public GraphicsException(String message) {
        this(message, null);
    }

    /**
     * @param message what failed and how to mend it; line breaks are replaced by spaces
     * @param cause the driver's or library's own failure
     */
    public GraphicsException(String message, Throwable cause) {
        super(oneLine(message), cause);
    }

    private static String oneLine(String message) {
        return message.strip().replaceAll("\\s*\\R\\s*", " ");
    }
}
