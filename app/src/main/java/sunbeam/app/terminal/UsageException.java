package sunbeam.app.terminal;

/** Thrown for options that are well formed but cannot be used; the message names them, their values and the remedy. */
public final class UsageException extends RuntimeException {
    public UsageException(String message) {
        super(message);
    }

    public static void throwIf(boolean isUnusable, String message) {
        if (isUnusable) {
            throw new UsageException(message);
        }
    }

    public static void requireWithin(String option, long value, long least, long most) {
        throwIf(
                value < least || value > most,
                option + " " + value + " is out of range; give " + least + " to " + most);
    }
}
