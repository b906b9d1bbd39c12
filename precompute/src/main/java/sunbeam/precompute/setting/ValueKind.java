package sunbeam.precompute.setting;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Angles;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/**
 * Type of a setting's values, with their text form and their limits.
 *
 * @param placeholder word for a value in the manual, such as LENGTH
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
    public enum Form {
        TEXT,
        /** A text with a number and its unit. */
        QUANTITY,
        /** A number; or a text, for a word that is allowed instead of the number. */
        NUMBER,
        /** true or false; on the command line, the option without a value, or its negation. */
        FLAG
    }

    /** Length in meters, written with its unit, within a range. */
    public static ValueKind<Double> length(double least, double largest) {
        return bounded("LENGTH", Form.QUANTITY, least, largest, Lengths::parse, Lengths::exact);
    }

    /** Angle in radians within a range, written with its unit; degrees if the unit is missing. */
    public static ValueKind<Double> angle(double least, double largest) {
        return bounded("ANGLE", Form.QUANTITY, least, largest, Angles::parse, Angles::format);
    }

    public static ValueKind<Double> number(String placeholder, double least, double largest) {
        return bounded(placeholder, Form.NUMBER, least, largest, ValueKind::number, Decimals::format);
    }

    public static ValueKind<Double> number(String placeholder, double least, double largest, String tooSmall) {
        ValueKind<Double> plain = number(placeholder, least, largest);
        UnaryOperator<Double> check = value -> {
            if (value > 0 && value < least) {
                throw new IllegalArgumentException(Decimals.format(value) + " is " + tooSmall);
            }
            return plain.check(value);
        };
        return new ValueKind<>(placeholder, plain.form(), plain.parser(), check, plain.formatter(), plain.range());
    }

    public static ValueKind<Integer> integer(String placeholder, int least, int largest) {
        return bounded(placeholder, Form.NUMBER, least, largest, ValueKind::whole, String::valueOf);
    }

    public static ValueKind<Boolean> flag() {
        Function<String, Boolean> parse = text -> switch (text) {
            case "true" -> true;
            case "false" -> false;
            default -> throw new IllegalArgumentException(Text.quoted(text) + " is neither true nor false");
        };
        return new ValueKind<>("", Form.FLAG, parse, value -> value, String::valueOf, "true or false");
    }

    public static <E extends Enum<E>> ValueKind<E> word(String placeholder, Class<E> type) {
        return oneOf(placeholder, List.of(type.getEnumConstants()), ValueKind::name);
    }

    /** Returns an enum constant's written name: lower case, hyphens between words. */
    public static String name(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    public static <T> ValueKind<T> oneOf(String placeholder, List<T> values, Function<T, String> name) {
        String names = values.stream().map(name).collect(Collectors.joining(", "));
        Function<String, T> parse = text -> values.stream()
                .filter(value -> name.apply(value).equals(text.strip().toLowerCase(Locale.ROOT)))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Text.quoted(text) + " is not one of " + names
                        + Text.nearest(text, values.stream().map(name).toList())
                                .map(near -> " (did you mean " + near + "?)")
                                .orElse("")));
        return text(placeholder, parse, name, names);
    }

    /** Values with a text form of their own; parse throws IllegalArgumentException, and the range describes valid texts. */
    public static <T> ValueKind<T> text(
            String placeholder, Function<String, T> parse, Function<T, String> format, String range) {
        return new ValueKind<>(placeholder, Form.TEXT, parse, value -> value, format, range);
    }

    public static ValueKind<String> text(String placeholder) {
        return text(placeholder, text -> text, text -> text, "a text");
    }

    private static <N extends Number & Comparable<N>> ValueKind<N> bounded(
            String placeholder,
            ValueKind.Form form,
            N least,
            N largest,
            Function<String, N> parse,
            Function<N, String> format) {
        String range = format.apply(least) + " to " + format.apply(largest);
        UnaryOperator<N> check = value -> {
            // NaN compares as larger than all.
            if (value.compareTo(least) < 0 || value.compareTo(largest) > 0) {
                throw new IllegalArgumentException(format.apply(value) + " is out of range; give " + range);
            }
            return value;
        };
        return new ValueKind<>(placeholder, form, parse, check, format, range);
    }

    private static double number(String text) {
        return Decimals.parse(text)
                .orElseThrow(() ->
                        new IllegalArgumentException(Text.quoted(text) + " is no number" + Decimals.remedy(text)));
    }

    private static int whole(String text) {
        double value = number(text);
        if (value != Math.rint(value) || Math.abs(value) > Integer.MAX_VALUE) {
            throw new IllegalArgumentException(Text.quoted(text) + " is no whole number");
        }
        return (int) value;
    }

    /** Parses a text; throws IllegalArgumentException, which quotes the text and gives a remedy, if it is no value within the limits. */
    public T parse(String text) {
        return checker.apply(parser.apply(text));
    }

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
