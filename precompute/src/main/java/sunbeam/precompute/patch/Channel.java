package sunbeam.precompute.patch;

import java.util.Locale;
import sunbeam.precompute.text.Quoted;

/** Which channel of an image holds the heights. */
public enum Channel {
    /** The only channel of a grey image, or the common one of a colour image whose red, green and blue are equal. */
    GREY,
    RED,
    GREEN,
    BLUE,
    ALPHA;

    /**
     * The channel of that name, in any case; "gray" is GREY.
     *
     * @throws IllegalArgumentException when there is none, with a message that shows the text and the names
     */
    public static Channel parse(String text) {
        return switch (text.strip().toLowerCase(Locale.ROOT)) {
            case "grey", "gray" -> GREY;
            case "red" -> RED;
            case "green" -> GREEN;
            case "blue" -> BLUE;
            case "alpha" -> ALPHA;
            default ->
                throw new IllegalArgumentException(
                        Quoted.of(text) + " is no channel; use grey, red, green, blue or alpha");
        };
    }

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
