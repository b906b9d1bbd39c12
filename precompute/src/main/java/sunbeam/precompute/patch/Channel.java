package sunbeam.precompute.patch;

import java.util.Locale;

/** Which channel of an image holds the heights. */
public enum Channel {
    /** The only channel of a grey image, or the common one of a colour image whose red, green and blue are equal. */
    GREY,
    RED,
    GREEN,
    BLUE,
    ALPHA;

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
