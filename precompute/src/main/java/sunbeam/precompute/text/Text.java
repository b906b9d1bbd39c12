package sunbeam.precompute.text;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Texts of messages: numbers with a decimal point and ASCII digits in every locale, untrusted texts in quotes, similar names. */
public final class Text {
    private static final int LONGEST_QUOTED = 60;
    private static final int LARGEST_DISTANCE = 2;

    private Text() {}

    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    /** "1 degree", "-86 degrees". */
    public static String wholeDegrees(double degrees) {
        String whole = format("%.0f", Math.rint(degrees) + 0.0);
        return whole + (whole.matches("-?1") ? " degree" : " degrees");
    }

    /** Returns an untrusted text in double quotes, on one line, cut after 60 characters. */
    public static String quoted(String text) {
        String shown = text.length() > LONGEST_QUOTED ? text.substring(0, LONGEST_QUOTED) + "..." : text;
        return '"' + oneLine(shown) + '"';
    }

    /** Replaces each control character (line breaks, escape sequences) and each half of a pair of surrogates by {@code ?}. */
    public static String oneLine(String text) {
        return text.replaceAll("[\\p{Cntrl}\\p{Cs}\\u2028\\u2029]", "?");
    }

    /** True if the names differ by at most two edits, and by at most half of the shorter name's letters. */
    public static boolean areSimilar(String one, String other) {
        return editDistance(one, other) <= Math.min(LARGEST_DISTANCE, Math.min(one.length(), other.length()) / 2);
    }

    public static Optional<String> nearest(String written, List<String> names) {
        String plain = plain(written);
        return names.stream()
                .filter(name -> areSimilar(plain, plain(name)))
                .min(Comparator.comparingInt(name -> editDistance(plain, plain(name))));
    }

    /** Returns a name without what users may write differently: case and blanks around it. */
    public static String plain(String name) {
        return name.strip().toLowerCase(Locale.ROOT);
    }

    private static int editDistance(String one, String other) {
        int[] above = new int[other.length() + 1];
        Arrays.setAll(above, column -> column);
        for (int row = 1; row <= one.length(); row++) {
            int[] current = new int[above.length];
            current[0] = row;
            for (int column = 1; column < current.length; column++) {
                int changed = above[column - 1] + (one.charAt(row - 1) == other.charAt(column - 1) ? 0 : 1);
                current[column] = Math.min(changed, 1 + Math.min(above[column], current[column - 1]));
            }
            above = current;
        }
        return above[other.length()];
    }
}
