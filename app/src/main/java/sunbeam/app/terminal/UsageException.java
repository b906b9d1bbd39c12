package sunbeam.app.terminal;

/** Options that are each well formed but do not go together; the message names them, their values and the remedy. */
public final class UsageException extends RuntimeException {
    public UsageException(String message) {
        super(message);
    }
}
