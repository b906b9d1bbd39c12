package sunbeam.precompute.scan.text;

import java.util.Locale;

/** What separates a number's whole part from its fraction in a text; the other separates numbers. */
public enum DecimalMark {
    POINT,
    COMMA;

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
