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

    /** Failure of a driver that works, but does less than what was asked. */
    public static final class BeyondLimit extends GraphicsException {
        public BeyondLimit(String message) {
            super(message);
        }
    }
}
