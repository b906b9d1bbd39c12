package sunbeam.precompute.scan.text;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.text.Quoted;

/** Numbers of text headers, read as strictly as the formats are loose: a header that lacks one is refused by its name. */
public final class HeaderText {
    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+[.,]?\\d*|[.,]\\d+)([eE][+-]?\\d{1,3})?");
    private static final Pattern QUANTITY = Pattern.compile("\\s*(" + NUMBER + ")\\s*(.*?)\\s*");

    /** A number and what follows it. */
    public record Quantity(double value, String unit) {}

    private HeaderText() {}

    /**
     * A value that is a count.
     *
     * @throws ScanException when it is missing or no positive whole number
     */
    public static int integer(Map<String, String> values, String name) {
        double value = number(values, name);
        if (value != Math.rint(value) || value < 1 || value > Integer.MAX_VALUE) {
            throw wrong(values, name);
        }
        return (int) value;
    }

    /**
     * A value that is a number.
     *
     * @throws ScanException when it is missing or no number
     */
    public static double number(Map<String, String> values, String name) {
        return number(values.getOrDefault(name, "")).orElseThrow(() -> wrong(values, name));
    }

    /**
     * A value that is a number, or another where it is missing.
     *
     * @throws ScanException when it is there and no number
     */
    public static double number(Map<String, String> values, String name, double otherwise) {
        return values.containsKey(name) ? number(values, name) : otherwise;
    }

    /**
     * A value that begins with a number.
     *
     * @throws ScanException when it is missing or does not
     */
    public static Quantity quantity(Map<String, String> values, String name) {
        return quantity(values.getOrDefault(name, "")).orElseThrow(() -> wrong(values, name));
    }

    /** A number with whatever follows it; nothing when the text does not begin with one. */
    public static Optional<Quantity> quantity(String text) {
        Matcher matcher = QUANTITY.matcher(text);
        if (text.length() > 1000 || !matcher.matches()) {
            return Optional.empty();
        }
        return Optional.of(new Quantity(plain(matcher.group(1)), matcher.group(4)));
    }

    /** A number alone, with a decimal point or comma. */
    public static OptionalDouble number(String text) {
        String stripped = text.strip();
        return stripped.length() < 100 && NUMBER.matcher(stripped).matches()
                ? OptionalDouble.of(plain(stripped))
                : OptionalDouble.empty();
    }

    private static double plain(String text) {
        return Double.parseDouble(text.replace(',', '.'));
    }

    private static ScanException wrong(Map<String, String> values, String name) {
        String value = values.get(name);
        return new ScanException(
                value == null
                        ? String.format(Locale.ROOT, "has no \"%s\" in its header; copy or export it again", name)
                        : String.format(
                                Locale.ROOT,
                                "has %s for \"%s\" in its header; export it again",
                                Quoted.of(value),
                                name));
    }
}
