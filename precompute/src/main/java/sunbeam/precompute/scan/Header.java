package sunbeam.precompute.scan;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Text;

/** Keys and values of a text header; exceptions name the key. */
public final class Header {
    /** Bytes: ten times the longest text header known. */
    public static final int LARGEST = 1 << 20;

    private static final Pattern QUANTITY =
            Pattern.compile("\\s*([+-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eEdD][+-]?\\d{1,3})?)\\s*(.*?)\\s*");
    private static final int LONGEST_QUANTITY = 1000;

    private final Map<String, String> values = new HashMap<>();
    private final Set<String> contradictory = new HashSet<>();

    /** Number, with a decimal point or comma, and its unit. */
    public record Quantity(double value, String unit) {
        public static Optional<Quantity> of(String text) {
            Matcher found = QUANTITY.matcher(text.length() <= LONGEST_QUANTITY ? text : "");
            if (!found.matches()) {
                return Optional.empty();
            }
            // Fortran writes 1.0D+01.
            String number = found.group(1).replace(',', '.').replace('d', 'e').replace('D', 'e');
            return Optional.of(new Quantity(Double.parseDouble(number), found.group(2)));
        }

        /** Empty if the unit is no unit of length; a number without a unit gets {@code unitOtherwise}. */
        public Optional<Double> meters(String unitOtherwise) {
            return Extent.metersPer(unit.isEmpty() ? unitOtherwise : unit).map(meters -> meters * value);
        }
    }

    /** Reads lines of key, separator and value; skips other lines. A key with two values is refused when it is read. */
    public static Header of(String text, char separator) {
        Header header = new Header();
        text.lines().forEach(line -> {
            int end = line.indexOf(separator);
            if (end > 0) {
                String key = line.substring(0, end).strip();
                header.put(key, line.substring(end + 1));
                if (!header.values.get(key).equals(line.substring(end + 1).strip())) {
                    header.contradictory.add(key);
                }
            }
        });
        return header;
    }

    /** Adds a value unless the key already has one. */
    public void put(String key, String value) {
        values.putIfAbsent(key.strip(), value.strip());
    }

    public boolean has(String key) {
        return values.containsKey(key);
    }

    public Optional<String> find(String key) {
        return Optional.of(text(key, "")).filter(value -> !value.isEmpty());
    }

    public String text(String key, String otherwise) {
        ScanException.refuseIf(
                contradictory.contains(key),
                "has several values for " + Text.quoted(key)
                        + " in its header; remove the wrong ones, or export it again");
        return values.getOrDefault(key, otherwise);
    }

    public int count(String key) {
        double value = number(key);
        if (value != Math.rint(value) || value < 1 || value > Integer.MAX_VALUE) {
            throw wrong(key);
        }
        return (int) value;
    }

    public double number(String key) {
        return Optional.of(quantity(key))
                .filter(quantity -> quantity.unit().isEmpty())
                .orElseThrow(() -> wrong(key))
                .value();
    }

    public double number(String key, double otherwise) {
        return has(key) ? number(key) : otherwise;
    }

    public Quantity quantity(String key) {
        return Quantity.of(text(key, "")).orElseThrow(() -> wrong(key));
    }

    /** Returns a length in meters; empty if the value is none. */
    public Optional<Double> meters(String key, String unitOtherwise) {
        return find(key).flatMap(Quantity::of).flatMap(quantity -> quantity.meters(unitOtherwise));
    }

    private ScanException wrong(String key) {
        return new ScanException(
                has(key)
                        ? "has " + Text.quoted(text(key, "")) + " for \"" + key + "\" in its header; export it again"
                        : "has no \"" + key + "\" in its header; copy or export it again");
    }
}
