package sunbeam.precompute.setting;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.text.Similar;
import sunbeam.precompute.units.Angles;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Creates kinds of values of settings. */
public final class Kinds {
    private Kinds() {}

    /** Length in meters, written with its unit, within a range. */
    public static ValueKind<Double> length(double least, double largest) {
        return bounded("LENGTH", ValueKind.Form.QUANTITY, least, largest, Lengths::parse, Lengths::exact);
    }

    /** Angle in radians within a range, written with its unit; degrees if the unit is missing. */
    public static ValueKind<Double> angle(double least, double largest) {
        return bounded("ANGLE", ValueKind.Form.QUANTITY, least, largest, Angles::parse, Angles::format);
    }

    /** Number without a unit, within a range. */
    public static ValueKind<Double> number(String placeholder, double least, double largest) {
        return bounded(placeholder, ValueKind.Form.NUMBER, least, largest, Kinds::number, Decimals::format);
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

    /** Whole number within a range. */
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
        return new ValueKind<>("", ValueKind.Form.FLAG, parse, value -> value, String::valueOf, "true or false");
    }

    /** One of an enum's constants, written as {@link #name}. */
    public static <E extends Enum<E>> ValueKind<E> word(String placeholder, Class<E> type) {
        return oneOf(placeholder, List.of(type.getEnumConstants()), Kinds::name);
    }

    /** Returns an enum constant's written name: lower case, hyphens between words. */
    public static String name(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** One of several values, by name. */
    public static <T> ValueKind<T> oneOf(String placeholder, List<T> values, Function<T, String> name) {
        String names = values.stream().map(name).collect(Collectors.joining(", "));
        Function<String, T> parse = text -> values.stream()
                .filter(value -> name.apply(value).equals(text.strip().toLowerCase(Locale.ROOT)))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Quoted.of(text) + " is not one of " + names
                        + Similar.nearest(text, values.stream().map(name).toList())
                                .map(near -> " (did you mean " + near + "?)")
                                .orElse("")));
        return text(placeholder, parse, name, names);
    }

    /**
     * Values with a text form of their own.
     *
     * @param parse throws IllegalArgumentException as {@link ValueKind#parse} does
     * @param range description of valid texts
     */
    public static <T> ValueKind<T> text(
            String placeholder, Function<String, T> parse, Function<T, String> format, String range) {
        return new ValueKind<>(placeholder, ValueKind.Form.TEXT, parse, value -> value, format, range);
    }

    /** Any text, such as a file's name. */
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
}
