package sunbeam.precompute.units;

import java.util.OptionalDouble;
import java.util.regex.Pattern;

/** Decimal numbers as people write them. */
public final class Decimals {
    /** Narrower than Double.parseDouble, which also takes 1d, 0x1p3 and NaN. */
    private static final Pattern DECIMAL = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

    private static final int LONGEST = 100;

    private Decimals() {}

    /** A number as people write it: whole ones without a point, powers of ten as 1e-5. */
    public static String format(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e7
                ? Long.toString((long) value)
                : Double.toString(value).replace(".0E", "e").replace('E', 'e');
    }

    /** The finite number that the text (blanks around it allowed) is, or nothing. */
    public static OptionalDouble parse(String text) {
        String digits = text.strip();
        if (digits.length() > LONGEST || !DECIMAL.matcher(digits).matches()) {
            return OptionalDouble.empty();
        }
        double value = Double.parseDouble(digits);
        return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
    }
}
