package sunbeam.precompute.units;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Text;

/** Parsing and formatting of decimal numbers. */
public final class Decimals {
    // Without what Double.parseDouble also accepts: 1d, 0x1p3 and NaN.
    private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");
    private static final int LONGEST = 100;
    private static final int MOST_PLACES = 9;
    private static final int EXACT_PLACES = 2;
    private static final Pattern DECIMAL_COMMA = Pattern.compile("(?<=\\d),(?=\\d)");

    private Decimals() {}

    public static String commaRemedy(String text) {
        if (text.contains(".")) {
            return "";
        }
        String pointed = DECIMAL_COMMA.matcher(text.strip()).replaceAll(".");
        return pointed.equals(text.strip()) ? "" : "; write a decimal point for the comma, " + Text.quoted(pointed);
    }

    /** Returns a remedy for a decimal comma or a percent sign, starting with a semicolon, or "". */
    public static String remedy(String text) {
        String written = text.strip();
        if (!written.endsWith("%")) {
            return commaRemedy(text);
        }
        OptionalDouble percent = parse(written.substring(0, written.length() - 1));
        if (percent.isEmpty()) {
            return "";
        }
        BigDecimal share = new BigDecimal(Double.toString(percent.getAsDouble())).movePointLeft(2);
        return "; write " + share.stripTrailingZeros().toPlainString() + " for that many percent";
    }

    /** Formats a number: whole numbers without a point, powers of ten as 1e-5. */
    public static String format(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e7
                ? Long.toString((long) value)
                : Double.toString(value).replace(".0E", "e").replace('E', 'e');
    }

    /** Formats a finite value to the given digits, never as a power of ten: 100, not 1.0e+02. */
    public static String rounded(double value, int digits) {
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(digits, RoundingMode.HALF_EVEN));
        return value == 0 ? "0" : rounded.toPlainString();
    }

    /** Formats a finite value to two digits of its uncertainty (half an interval); if that is 0, to two decimals. */
    public static String within(double value, double uncertainty) {
        int places = uncertainty > 0 && Double.isFinite(uncertainty)
                ? (int) Math.min(MOST_PLACES, 1 - Math.floor(Math.log10(uncertainty)))
                : EXACT_PLACES;
        return new BigDecimal(value).setScale(places, RoundingMode.HALF_EVEN).toPlainString();
    }

    public static OptionalDouble parse(String text) {
        String digits = text.strip();
        if (digits.length() > LONGEST || !DECIMAL.matcher(digits).matches()) {
            return OptionalDouble.empty();
        }
        double value = Double.parseDouble(digits);
        return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
    }
}
