package sunbeam.precompute.text;

import java.util.Locale;

/** Formatting of texts with numbers, independent of the locale. */
public final class Text {
    private Text() {}

    /** Formats as {@link String#format(String, Object...)} does, with a decimal point and ASCII digits. */
    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
