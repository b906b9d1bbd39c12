package sunbeam.precompute.text;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Suggestions for misspelled names. */
public final class Similar {
    private static final int LARGEST_DISTANCE = 2;

    private Similar() {}

    /** True if the names differ by at most two edits, and by at most half of the shorter name's letters. */
    public static boolean are(String one, String other) {
        return editDistance(one, other) <= Math.min(LARGEST_DISTANCE, Math.min(one.length(), other.length()) / 2);
    }

    public static Optional<String> nearest(String written, List<String> names) {
        String plain = plain(written);
        return names.stream()
                .filter(name -> are(plain, plain(name)))
                .min(Comparator.comparingInt(name -> editDistance(plain, plain(name))));
    }

    private static String plain(String name) {
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
