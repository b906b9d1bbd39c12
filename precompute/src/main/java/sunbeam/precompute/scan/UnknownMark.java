package sunbeam.precompute.scan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Refusal of a text whose commas may be decimal marks, and separate numbers or thousands as well. */
public final class UnknownMark extends ScanException {
    private static final long serialVersionUID = 1;

    // Commas and points within a line of semicolons, "1,024.5" before a blank, or "1.024,5" beside one.
    private static final Pattern THOUSANDS =
            Pattern.compile("(?m)^(?=[^;\n]*;)(?=[^.\n]*\\.)[^,\n]*,|(?<![\\d.,])\\d{1,3}(?:,\\d{3})+\\.\\d+[ \\t]"
                    + "|(?<![\\d.,])\\d{1,3}(?:\\.\\d{3})+,\\d+[ \\t]+[-+\\d]");
    /** Every tenth last digit is a zero, so that so many words without one are no whole numbers but once in 1000 files (0.9^64). */
    private static final int MANY = 64;

    private static final Predicate<String> DIGITS = Pattern.compile("\\d+").asMatchPredicate();
    private static final Predicate<String> FIRST_ZERO = Pattern.compile("0\\d+").asMatchPredicate();
    private static final Predicate<String> LAST_ZERO = Pattern.compile("\\d+0").asMatchPredicate();

    UnknownMark(String message) {
        super(message);
    }

    /** Finds what is wrong with lines of numbers, of which the last may be cut after a word. */
    static Optional<String> in(String numbers) {
        if (THOUSANDS.matcher(numbers).find()) {
            return Optional.of("has commas and points in a line, as thousands separators are; export it without them");
        }
        return commasMayBeBoth(numbers)
                ? Optional.of(
                        "has commas that may be decimal marks and separators at once, as in 1,5,2,5; export it with"
                                + " decimal points, or with semicolons between numbers")
                : Optional.empty();
    }

    /** True if all words between commas are digits and every second one has the form of decimals, which whole numbers lack. */
    private static boolean commasMayBeBoth(String numbers) {
        List<String[]> rows = numbers.lines()
                .map(line -> line.strip().replaceAll("\"|,$", "").split(",", -1))
                .filter(row -> !row[0].isEmpty())
                .toList();
        List<String> integers = new ArrayList<>();
        List<String> decimals = new ArrayList<>();
        for (String[] row : rows) {
            for (int i = 0; i + 1 < row.length; i += 2) {
                integers.add(row[i].replaceFirst("^[-+\u2212]", ""));
                decimals.add(row[i + 1]);
            }
        }
        return rows.stream().limit(rows.size() - 1L).allMatch(row -> row.length % 2 == 0)
                && Stream.concat(integers.stream(), decimals.stream()).allMatch(DIGITS)
                && !decimals.isEmpty()
                && areDecimals(decimals, integers);
    }

    /** Decimals are padded with zeros to one length (1.50), or end in no zero (1.5); all but single ones may begin with one. */
    private static boolean areDecimals(List<String> decimals, List<String> others) {
        int length = decimals.get(0).length();
        boolean padded = decimals.stream().allMatch(word -> word.length() == length)
                && (length == 1 || others.stream().anyMatch(word -> word.length() != length));
        boolean leading =
                decimals.stream().anyMatch(FIRST_ZERO) && others.stream().noneMatch(FIRST_ZERO);
        boolean shortest = decimals.stream().noneMatch(LAST_ZERO)
                && (decimals.size() < MANY || others.stream().anyMatch(LAST_ZERO));
        return padded || leading || shortest;
    }
}
