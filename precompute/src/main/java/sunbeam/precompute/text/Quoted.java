package sunbeam.precompute.text;

/** Formats untrusted text for messages: in quotes, on one line, of limited length. */
public final class Quoted {
    private static final int LONGEST = 60;

    private Quoted() {}

    public static String of(String text) {
        String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
        return '"' + oneLine(shown) + '"';
    }

    /** Replaces each control character (line breaks, escape sequences) by {@code ?}. */
    public static String oneLine(String text) {
        return text.replaceAll("[\\p{Cntrl}\\u2028\\u2029]", "?");
    }
}
