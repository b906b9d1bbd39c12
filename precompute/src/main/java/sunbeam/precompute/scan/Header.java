package sunbeam.precompute.scan;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Quoted;

/** Keys and values of a text header, read as strictly as formats are loose: one that lacks a key is refused by its name. */
public final class Header {
    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+[.,]?\\d*|[.,]\\d+)([eE][+-]?\\d{1,3})?");
    private static final Pattern QUANTITY = Pattern.compile("\\s*(" + NUMBER + ")\\s*(.*?)\\s*");
    private static final int LONGEST_QUANTITY = 1000;
    private static final int LONGEST_NUMBER = 100;

    private final Map<String, String> values = new HashMap<>();

    /** A number and what follows it. */
    public record Quantity(double value, String unit) {}

    /** Lines of a key, a separator and a value; others are passed over. */
    public static Header of(String text, char separator) {
        Header header = new Header();
        text.lines().forEach(line -> {
            int end = line.indexOf(separator);
            if (end > 0) {
                header.put(line.substring(0, end), line.substring(end + 1));
            }
        });
        return header;
    }

    /** Takes a value unless the key has one already. */
    public void put(String key, String value) {
        values.putIfAbsent(key.strip(), value.strip());
    }

    public boolean has(String key) {
        return values.containsKey(key);
    }

    /** A value; nothing where it is missing or blank. */
    public Optional<String> find(String key) {
        return Optional.ofNullable(values.get(key)).filter(value -> !value.isEmpty());
    }

    /** A value, or another where it is missing. */
    public String text(String key, String otherwise) {
        return values.getOrDefault(key, otherwise);
    }

    /**
     * A value that is a count.
     *
     * @throws ScanException when it is missing or no positive whole number
     */
    public int count(String key) {
        double value = number(key);
        if (value != Math.rint(value) || value < 1 || value > Integer.MAX_VALUE) {
            throw wrong(key);
        }
        return (int) value;
    }

    /**
     * A value that is a number.
     *
     * @throws ScanException when it is missing or no number
     */
    public double number(String key) {
        return number(Optional.of(text(key, ""))).orElseThrow(() -> wrong(key));
    }

    /**
     * A value that is a number, or another where it is missing.
     *
     * @throws ScanException when it is there and no number
     */
    public double number(String key, double otherwise) {
        return has(key) ? number(key) : otherwise;
    }

    /**
     * A value that begins with a number.
     *
     * @throws ScanException when it is missing or does not
     */
    public Quantity quantity(String key) {
        return quantity(Optional.of(text(key, ""))).orElseThrow(() -> wrong(key));
    }

    /** A length in metres; nothing where the value is missing, no quantity, or in no unit of length. */
    public Optional<Double> metres(String key, String unitOtherwise) {
        return metres(find(key), unitOtherwise);
    }

    /** A number with whatever follows it; nothing when the text does not begin with one. */
    public static Optional<Quantity> quantity(Optional<String> text) {
        return text.filter(some -> some.length() <= LONGEST_QUANTITY)
                .map(QUANTITY::matcher)
                .filter(Matcher::matches)
                .map(found -> new Quantity(plain(found.group(1)), found.group(4)));
    }

    /** The same as a length in metres; nothing when it is in no unit of length. */
    public static Optional<Double> metres(Optional<String> text, String unitOtherwise) {
        return quantity(text)
                .flatMap(quantity -> LengthUnit.metres(quantity.unit().isEmpty() ? unitOtherwise : quantity.unit())
                        .map(metres -> metres * quantity.value()));
    }

    /** A number alone, with a decimal point or comma. */
    public static OptionalDouble number(Optional<String> text) {
        return text.map(String::strip)
                .filter(some ->
                        some.length() < LONGEST_NUMBER && NUMBER.matcher(some).matches())
                .map(some -> OptionalDouble.of(plain(some)))
                .orElse(OptionalDouble.empty());
    }

    private static double plain(String text) {
        return Double.parseDouble(text.replace(',', '.'));
    }

    private ScanException wrong(String key) {
        return new ScanException(
                has(key)
                        ? String.format(
                                Locale.ROOT,
                                "has %s for \"%s\" in its header; export it again",
                                Quoted.of(text(key, "")),
                                key)
                        : "has no \"" + key + "\" in its header; copy or export it again");
    }
}
