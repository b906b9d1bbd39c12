package sunbeam.precompute.setting;

import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * Type of a setting's values, with their text form and their limits.
 *
 * @param placeholder word for a value in the manual, such as LENGTH
 * @param form form of a value in files
 * @param parser converts a text to a value; throws IllegalArgumentException as {@link #parse} does
 * @param checker returns a value within the limits unchanged, otherwise throws IllegalArgumentException
 * @param formatter converts a value to a text that the parser reads again
 * @param range allowed values, for manuals and messages: "100 nm to 10 mm", "taylor, lowrank"
 * @param <T> type of values; immutable
 */
public record ValueKind<T>(
        String placeholder,
        Form form,
        Function<String, T> parser,
        UnaryOperator<T> checker,
        Function<T, String> formatter,
        String range) {
    /** Form of a value in files. */
    public enum Form {
        TEXT,
        /** A text with a number and its unit. */
        QUANTITY,
        /** A number; or a text, for a word that is allowed instead of the number. */
        NUMBER,
        /** true or false; on the command line, the option without a value, or its negation. */
        FLAG
    }

    /**
     * Parses a text to a value within the limits.
     *
     * @throws IllegalArgumentException if the text is no such value; the message quotes the text and gives a remedy
     */
    public T parse(String text) {
        return checker.apply(parser.apply(text));
    }

    /** Returns a value within the limits; throws as {@link #parse}. */
    public T check(T value) {
        return checker.apply(value);
    }

    public String format(T value) {
        return formatter.apply(value);
    }

    /** Returns a kind that also parses other spellings of some values; keys in lower case. */
    public ValueKind<T> alsoWritten(Map<String, String> spellings) {
        Function<String, T> parse =
                text -> parser.apply(spellings.getOrDefault(text.strip().toLowerCase(Locale.ROOT), text));
        return new ValueKind<>(placeholder, form, parse, checker, formatter, range);
    }
}
