package sunbeam.precompute.scan;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Quoted;

/** Keys and values of a text header, read as strictly as formats are loose: one that lacks a key is refused by its name. */
public final class Header {
    /** Bytes of the longest header of text that is read: ten times the longest known. */
    public static final int LARGEST = 1 << 20;

    private static final Pattern QUANTITY =
            Pattern.compile("\\s*([+-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eEdD][+-]?\\d{1,3})?)\\s*(.*?)\\s*");
    private static final int LONGEST_QUANTITY = 1000;

    private final Map<String, String> values = new HashMap<>();

    /** A number, with a decimal point or comma, and what follows it. */
    public record Quantity(double value, String unit) {
        /** Nothing when the text does not begin with a number. */
        public static Optional<Quantity> of(String text) {
            Matcher found = QUANTITY.matcher(text.length() <= LONGEST_QUANTITY ? text : "");
            return found.matches()
                    ? Optional.of(new Quantity(
                            Double.parseDouble(found.group(1)
                                    .replace(',', '.')
                                    .replace('d', 'e')
                                    .replace('D', 'e')),
                            found.group(2)))
                    : Optional.empty();
        }

        /** As a length; nothing when it is in no unit of length. */
        public Optional<Double> meters(String unitOtherwise) {
            return LengthUnit.meters(unit.isEmpty() ? unitOtherwise : unit).map(meters -> meters * value);
        }
    }

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
        Quantity quantity = quantity(key);
        if (!quantity.unit().isEmpty()) {
            throw wrong(key);
        }
        return quantity.value();
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
        return Quantity.of(text(key, "")).orElseThrow(() -> wrong(key));
    }

    /** A length in meters; nothing where the value is missing, no quantity, or in no unit of length. */
    public Optional<Double> meters(String key, String unitOtherwise) {
        return find(key).flatMap(Quantity::of).flatMap(quantity -> quantity.meters(unitOtherwise));
    }

    private ScanException wrong(String key) {
        return new ScanException(
                has(key)
                        ? "has " + Quoted.of(text(key, "")) + " for \"" + key + "\" in its header; export it again"
                        : "has no \"" + key + "\" in its header; copy or export it again");
    }
}
