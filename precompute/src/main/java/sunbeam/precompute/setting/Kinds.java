package sunbeam.precompute.setting;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.text.Similar;
import sunbeam.precompute.units.Angles;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** The kinds of values that settings have. */
public final class Kinds {
    private Kinds() {}

    /** A length in metres, written with its unit, from a least to a largest. */
    public static ValueKind<Double> length(double least, double largest) {
        return bounded("LENGTH", ValueKind.Form.QUANTITY, least, largest, Lengths::parse, Lengths::exact);
    }

    /** An angle in radians, written with its unit, from a least to a largest; degrees where a place leaves the unit out. */
    public static ValueKind<Double> angle(double least, double largest) {
        return bounded("ANGLE", ValueKind.Form.QUANTITY, least, largest, Angles::parse, Angles::format);
    }

    /** A number without a unit, from a least to a largest. */
    public static ValueKind<Double> number(String placeholder, double least, double largest) {
        return bounded(placeholder, ValueKind.Form.NUMBER, least, largest, Kinds::number, Decimals::format);
    }

    /**
     * A number without a unit, from a least to a largest.
     *
     * @param tooSmall said of positive numbers below the least, continuing "1e-7 is "
     */
    public static ValueKind<Double> number(String placeholder, double least, double largest, String tooSmall) {
        TextKind<Double> plain =
                bounded(placeholder, ValueKind.Form.NUMBER, least, largest, Kinds::number, Decimals::format);
        return plain.checkedBefore(value -> {
            if (value > 0 && value < least) {
                throw new IllegalArgumentException(Decimals.format(value) + " is " + tooSmall);
            }
            return value;
        });
    }

    /** A whole number, from a least to a largest. */
    public static ValueKind<Integer> integer(String placeholder, int least, int largest) {
        return bounded(placeholder, ValueKind.Form.NUMBER, least, largest, Kinds::whole, String::valueOf);
    }

    /** Yes or no. */
    public static ValueKind<Boolean> flag() {
        Function<String, Boolean> parse = text -> switch (text) {
            case "true" -> true;
            case "false" -> false;
            default -> throw new IllegalArgumentException(Quoted.of(text) + " is neither true nor false");
        };
        return new TextKind<>("", ValueKind.Form.FLAG, parse, value -> value, String::valueOf, "true or false");
    }

    /** One of an enum's constants, by its name in lower case. */
    public static <E extends Enum<E>> ValueKind<E> word(String placeholder, Class<E> type) {
        return oneOf(
                placeholder,
                List.of(type.getEnumConstants()),
                word -> word.name().toLowerCase(Locale.ROOT));
    }

    /** One of some values, by name. */
    public static <T> ValueKind<T> oneOf(String placeholder, List<T> values, Function<T, String> name) {
        String names = values.stream().map(name).collect(Collectors.joining(", "));
        Function<String, T> parse = text -> values.stream()
                .filter(value -> name.apply(value).equals(text.strip().toLowerCase(Locale.ROOT)))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Quoted.of(text) + " is not one of " + names
                        + Similar.nearest(text, values.stream().map(name).toList())
                                .map(near -> " (did you mean " + near + "?)")
                                .orElse("")));
        return new TextKind<>(placeholder, ValueKind.Form.TEXT, parse, value -> value, name, names);
    }

    /**
     * The same values, some of which may be written otherwise, too.
     *
     * @param spellings in lower case, to what is written usually
     */
    public static <T> ValueKind<T> alsoWritten(ValueKind<T> kind, Map<String, String> spellings) {
        Function<String, T> parse =
                text -> kind.parse(spellings.getOrDefault(text.strip().toLowerCase(Locale.ROOT), text));
        return of(kind.placeholder(), kind.form(), parse, kind::check, kind::format, kind.range());
    }

    /**
     * Values of any kind.
     *
     * @param parse from a text; throws IllegalArgumentException as {@link ValueKind#parse} does
     * @param check of a value; gives it back, or throws IllegalArgumentException
     * @param format to a text
     * @param range what may be written
     */
    public static <T> ValueKind<T> of(
            String placeholder,
            ValueKind.Form form,
            Function<String, T> parse,
            UnaryOperator<T> check,
            Function<T, String> format,
            String range) {
        return new TextKind<>(placeholder, form, parse, check, format, range);
    }

    /** Any text, such as a file's name. */
    public static ValueKind<String> text(String placeholder) {
        return new TextKind<>(placeholder, ValueKind.Form.TEXT, text -> text, text -> text, text -> text, "a text");
    }

    private static <N extends Number & Comparable<N>> TextKind<N> bounded(
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
        return new TextKind<>(placeholder, form, parse, check, format, range);
    }

    private static double number(String text) {
        return Decimals.parse(text)
                .orElseThrow(
                        () -> new IllegalArgumentException(Quoted.of(text) + " is no number" + Decimals.remedy(text)));
    }

    private static int whole(String text) {
        double value = number(text);
        if (value != Math.rint(value) || Math.abs(value) > Integer.MAX_VALUE) {
            throw new IllegalArgumentException(Quoted.of(text) + " is no whole number");
        }
        return (int) value;
    }

    private record TextKind<T>(
            String placeholder,
            Form form,
            Function<String, T> parser,
            UnaryOperator<T> checker,
            Function<T, String> formatter,
            String range)
            implements ValueKind<T> {
        private TextKind<T> checkedBefore(UnaryOperator<T> check) {
            return new TextKind<>(
                    placeholder, form, parser, value -> checker.apply(check.apply(value)), formatter, range);
        }

        @Override
        public T parse(String text) {
            return checker.apply(parser.apply(text));
        }

        @Override
        public T check(T value) {
            return checker.apply(value);
        }

        @Override
        public String format(T value) {
            return formatter.apply(value);
        }
    }
}
