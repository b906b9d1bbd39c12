package sunbeam.precompute.text;

/** How a message shows text that came from outside: in quotes, on one line, never longer than a line bears. */
public final class Quoted {
    private static final int LONGEST = 60;

    private Quoted() {}

    /** The text in double quotes, control characters as {@code ?}, cut after 60 characters. */
    public static String of(String text) {
        String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
        return '"' + oneLine(shown) + '"';
    }

    /** The text with each control character (line breaks, escape sequences) replaced by {@code ?}. */
    public static String oneLine(String text) {
        return text.replaceAll("[\\p{Cntrl}\\u2028\\u2029]", "?");
    }
}
