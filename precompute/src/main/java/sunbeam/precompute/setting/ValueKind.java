package sunbeam.precompute.setting;

import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * The values that a setting takes, as people write them.
 *
 * @param placeholder what stands for a value in a manual, such as LENGTH
 * @param form how a file writes it
 * @param parser from a text; throws IllegalArgumentException as {@link #parse} does
 * @param checker of a value; gives it back, or throws IllegalArgumentException
 * @param formatter to a text that the parser reads again
 * @param range what may be written, for manuals and messages: "100 nm to 10 mm", "taylor, lowrank"
 * @param <T> of a value; immutable
 */
public record ValueKind<T>(
        String placeholder,
        Form form,
        Function<String, T> parser,
        UnaryOperator<T> checker,
        Function<T, String> formatter,
        String range) {
    /** How a file writes such a value. */
    public enum Form {
        /** A text. */
        TEXT,
        /** A text of a number and its unit. */
        QUANTITY,
        /** A bare number; or a text that is none, such as a word in a number's place. */
        NUMBER,
        /** true or false; on the command line the option alone, or its negation. */
        FLAG
    }

    /**
     * The value, within the limits.
     *
     * @throws IllegalArgumentException when it is none; the message shows the text and says what to write instead, and does
     *     not name the setting
     */
    public T parse(String text) {
        return checker.apply(parser.apply(text));
    }

    /**
     * A value that came from elsewhere, within the limits.
     *
     * @throws IllegalArgumentException as {@link #parse}
     */
    public T check(T value) {
        return checker.apply(value);
    }

    /** The value as {@link #parse} reads it again. */
    public String format(T value) {
        return formatter.apply(value);
    }

    /**
     * The same values, some of which may be written otherwise, too.
     *
     * @param spellings in lower case, to what is written usually
     */
    public ValueKind<T> alsoWritten(Map<String, String> spellings) {
        Function<String, T> parse =
                text -> parser.apply(spellings.getOrDefault(text.strip().toLowerCase(Locale.ROOT), text));
        return new ValueKind<>(placeholder, form, parse, checker, formatter, range);
    }
}
