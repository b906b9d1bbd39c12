package sunbeam.precompute.setting;

/**
 * The values that a setting takes, as people write them.
 *
 * @param <T> of a value; immutable
 */
public interface ValueKind<T> {
    /** How a file writes such a value. */
    enum Form {
        /** A text. */
        TEXT,
        /** A text of a number and its unit. */
        QUANTITY,
        /** A bare number; or a text that is none, such as a word in a number's place. */
        NUMBER,
        /** true or false; on the command line the option alone, or its negation. */
        FLAG
    }

    /** What stands for a value in a manual, such as LENGTH. */
    String placeholder();

    /** How a file writes it. */
    Form form();

    /**
     * The value, within the limits.
     *
     * @throws IllegalArgumentException when it is none; the message shows the text and says what to write instead, and does
     *     not name the setting
     */
    T parse(String text);

    /**
     * A value that came from elsewhere, within the limits.
     *
     * @throws IllegalArgumentException as {@link #parse}
     */
    T check(T value);

    /** The value as {@link #parse} reads it again. */
    String format(T value);

    /** What may be written, for manuals and messages: "100 nm to 10 mm", "taylor, lowrank". */
    String range();
}
