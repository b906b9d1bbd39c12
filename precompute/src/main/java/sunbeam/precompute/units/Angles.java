package sunbeam.precompute.units;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import sunbeam.precompute.text.Text;

/** Conversion of angles as text ("30 deg", "30°", "0.5rad"; degrees where no unit is written) to and from radians. */
public final class Angles {
    // The conversion from radians to degrees spoils a double's last digits.
    private static final int DIGITS = 12;
    private static final int UNIT_LENGTH = 3;

    private Angles() {}

    /** Throws IllegalArgumentException when the text has no number or an unknown unit. */
    public static double parse(String text) {
        String value = text.strip().toLowerCase(Locale.ROOT).replaceFirst("\u00b0$", "deg");
        boolean radians = value.endsWith("rad");
        String digits = radians || value.endsWith("deg") ? value.substring(0, value.length() - UNIT_LENGTH) : value;
        double number = Decimals.parse(digits)
                .orElseThrow(() -> new IllegalArgumentException(
                        Text.quoted(text) + " is no angle; give degrees as in 30deg, or radians as in 0.5rad"
                                + Decimals.commaRemedy(text)));
        return radians ? number : Math.toRadians(number);
    }

    public static String format(double radians) {
        if (!Double.isFinite(radians)) {
            return radians + " deg";
        }
        BigDecimal degrees = new BigDecimal(Math.toDegrees(radians)).round(new MathContext(DIGITS));
        return Decimals.format(degrees.doubleValue()) + " deg";
    }
}
