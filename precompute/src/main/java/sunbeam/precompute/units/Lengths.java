package sunbeam.precompute.units;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Text;

/** Conversion of lengths to and from meters, with a unit of pm, nm, um, mm, cm or m, and either Unicode mu for the u. */
public final class Lengths {
    private static final Map<String, Integer> POWER_OF_TEN =
            Map.of("pm", -12, "nm", -9, "um", -6, "mm", -3, "cm", -2, "m", 0);
    private static final String[] ENGINEERING_UNITS = {"pm", "nm", "um", "mm", "m"};
    private static final int SHOWN_DIGITS = 6;
    // Meters; shorter ones are rounding errors.
    private static final double SMALLEST = 1e-15;
    // They distinguish every double from its neighbors.
    private static final int MOST_DIGITS = 17;

    /** More digits of exponent would make the decimal arithmetic slow. */
    private static final Pattern LENGTH =
            Pattern.compile("([+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)\\s*(\\S*)");

    private Lengths() {}

    /**
     * Parses a length to meters, correctly rounded: {@code parse("65um") == 65e-6}. Negative lengths are accepted.
     *
     * @throws IllegalArgumentException when the text has no number, no unit or an unknown unit
     */
    public static double parse(String text) {
        String trimmed = text.strip();
        Matcher matcher = LENGTH.matcher(trimmed);
        if (trimmed.length() > 100 || !matcher.matches()) {
            throw new IllegalArgumentException(
                    Text.quoted(text) + " is no length; write a number with its unit, such as 65um or 375 nm");
        }
        String remedy = matcher.group(2).startsWith(",") ? Decimals.commaRemedy(trimmed) : "";
        if (!remedy.isEmpty()) {
            throw new IllegalArgumentException(Text.quoted(text) + " is no length" + remedy);
        }
        String unit = matcher.group(2).replace('\u00b5', 'u').replace('\u03bc', 'u');
        if (unit.isEmpty()) {
            throw new IllegalArgumentException(
                    Text.quoted(text) + " has no unit; write the length with pm, nm, um, mm, cm or m, such as 65um");
        }
        Integer power = POWER_OF_TEN.get(unit);
        if (power == null) {
            throw new IllegalArgumentException(Text.quoted(text) + " has the unknown unit "
                    + Text.quoted(matcher.group(2)) + "; use pm, nm, um, mm, cm or m");
        }
        return new BigDecimal(matcher.group(1)).scaleByPowerOfTen(power).doubleValue();
    }

    /** Formats with at most six digits, in the unit that makes it 1 to 1000: {@code "818.69 nm"}. */
    public static String format(double meters) {
        return format(meters, SHOWN_DIGITS);
    }

    /** Formats with the given digits; a rounding error, below a femtometer, as 0. */
    public static String rounded(double meters, int digits) {
        return format(Math.abs(meters) < SMALLEST ? 0 : meters, digits);
    }

    /** Formats with enough digits for {@link #parse} to return the same number. */
    public static String exact(double meters) {
        for (int digits = SHOWN_DIGITS; digits < MOST_DIGITS; digits++) {
            String text = format(meters, digits);
            if (!Double.isFinite(meters) || parse(text) == meters) {
                return text;
            }
        }
        return format(meters, MOST_DIGITS);
    }

    private static String format(double meters, int digits) {
        if (meters == 0 || !Double.isFinite(meters)) {
            return (meters == 0 ? "0" : Double.toString(meters)) + " m";
        }
        BigDecimal rounded = new BigDecimal(meters).round(new MathContext(digits, RoundingMode.HALF_EVEN));
        // Digits before the decimal point in meters: -4 for 6.5e-5.
        int magnitude = rounded.precision() - rounded.scale();
        int index = Math.max(0, Math.min(ENGINEERING_UNITS.length - 1, Math.floorDiv(magnitude - 1, 3) + 4));
        String unit = ENGINEERING_UNITS[index];
        BigDecimal value = rounded.scaleByPowerOfTen(-POWER_OF_TEN.get(unit)).stripTrailingZeros();
        boolean readable = Math.abs(value.precision() - value.scale()) <= 9;
        return (readable ? value.toPlainString() : value.toString()) + " " + unit;
    }
}
