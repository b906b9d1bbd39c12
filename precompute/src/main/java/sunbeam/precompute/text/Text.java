package sunbeam.precompute.text;

import java.util.Locale;

/** Formatting with a decimal point and ASCII digits in every locale. */
public final class Text {
    private Text() {}

    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
