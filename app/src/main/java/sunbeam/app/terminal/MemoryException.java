package sunbeam.app.terminal;

/** Thrown if a command needs more memory than Java has; the message says for what, how much there is, and the remedy. */
public final class MemoryException extends RuntimeException {
    public MemoryException(String message) {
        super(message);
    }
}
