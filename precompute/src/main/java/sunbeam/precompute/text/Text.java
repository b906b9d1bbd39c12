package sunbeam.precompute.text;

import java.util.Locale;

/** Formatting with a decimal point and ASCII digits in every locale. */
public final class Text {
    private Text() {}

    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    /** "1 degree", "-86 degrees". */
    public static String wholeDegrees(double degrees) {
        String whole = format("%.0f", Math.rint(degrees) + 0.0);
        return whole + (whole.matches("-?1") ? " degree" : " degrees");
    }
}
