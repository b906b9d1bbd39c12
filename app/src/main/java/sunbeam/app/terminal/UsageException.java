package sunbeam.app.terminal;

import java.util.function.Supplier;

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

    /** Parses an option's value; the message of an {@link IllegalArgumentException} continues that of the usage error. */
    public static <T> T parsed(String message, Supplier<T> parser) {
        try {
            return parser.get();
        } catch (IllegalArgumentException wrong) {
            throw new UsageException(message + wrong.getMessage());
        }
    }

    public static void requireWithin(String option, long value, long least, long most) {
        throwIf(
                value < least || value > most,
                option + " " + value + " is out of range; give " + least + " to " + most);
    }
}
