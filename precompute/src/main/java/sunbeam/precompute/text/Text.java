package sunbeam.precompute.text;

import java.util.Locale;

/** Texts with numbers, written alike in every country. */
public final class Text {
    private Text() {}

    /** As {@link String#format(String, Object...)} with digits and marks that programs read. */
    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
