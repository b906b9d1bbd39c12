package sunbeam.precompute.scan;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.Arrays;
import java.util.StringTokenizer;
import java.util.regex.Pattern;
import sunbeam.precompute.text.Quoted;

/** Numbers of a text; an empty field is a missing sample. */
public final class TextNumbers {
    private static final Pattern MISSING = Pattern.compile("(?i)[-+]?(nan|nan\\(ind\\)|inf|infinity)|bad|---?|#?n/a");
    private static final int FIRST_CAPACITY = 1 << 12;
    // Three for each point of the largest grid.
    private static final long MOST = 3 * ScanLimits.MOST_SAMPLES;
    private static final int LONGEST_WORD = 100;

    private static final String BLANKS = " \t\"\f\ufeff";

    private final boolean decimalComma;
    private double[] values = new double[FIRST_CAPACITY];
    private int count;
    private int columns;
    private int rows;
    private String ragged = "";

    private TextNumbers(boolean decimalComma) {
        this.decimalComma = decimalComma;
    }

    /** Reads numbers; throws ScanException if there are too many, or a word that is no number. */
    public static TextNumbers read(BufferedReader in, boolean decimalComma, long line, long most) throws IOException {
        TextNumbers numbers = new TextNumbers(decimalComma);
        long number = line;
        for (String text = in.readLine(); text != null && numbers.count < most; text = in.readLine()) {
            numbers.add(text, number++);
        }
        return numbers;
    }

    private void add(String text, long line) {
        int before = count;
        boolean separated = false;
        String separators = decimalComma ? ";" : ";,";
        StringTokenizer tokens = new StringTokenizer(text, separators + BLANKS, true);
        while (tokens.hasMoreTokens()) {
            String token = tokens.nextToken();
            boolean separator = separators.contains(token);
            if (separator && separated) {
                add(Double.NaN);
            } else if (!separator && !BLANKS.contains(token)) {
                add(parse(token, line));
                separated = false;
            }
            separated |= separator;
        }
        int added = count - before;
        rows += added > 0 ? 1 : 0;
        columns = rows == 1 && added > 0 ? added : columns;
        if (added > 0 && added != columns && ragged.isEmpty()) {
            ragged = added + " numbers in line " + line;
        }
    }

    private double parse(String word, long line) {
        // In "1,5, 2,5" the comma after the first number is a separator.
        boolean trailing = decimalComma && word.length() > 1 && word.endsWith(",");
        String text = (trailing ? word.substring(0, word.length() - 1) : word)
                .replace(',', '.')
                .replace('\u2212', '-');
        // Double.parseDouble also accepts 1d, 0x1p3 and Infinity. Fortran writes 1.0D+01.
        if (text.length() <= LONGEST_WORD
                && text.chars().allMatch(c -> (c >= '0' && c <= '9') || "+-.eEdD".indexOf(c) >= 0)) {
            try {
                return Double.parseDouble(text.replace('d', 'e').replace('D', 'e'));
            } catch (NumberFormatException none) {
                // Refused below.
            }
        }
        if (MISSING.matcher(text).matches()) {
            return Double.NaN;
        }
        throw new ScanException("has " + Quoted.of(text) + " in line " + line
                + ", where a number should be; remove it, or say which mark its decimals have");
    }

    private void add(double value) {
        if (count == values.length) {
            ScanException.refuseIf(
                    count >= MOST, "has more than " + MOST + " numbers, more than can be used; crop the scan");
            ScanLimits.requireMemory(2L * count, 0);
            values = Arrays.copyOf(values, (int) Math.min(MOST, 2L * count));
        }
        values[count++] = value;
    }

    int count() {
        return count;
    }

    int columns() {
        return columns;
    }

    int rows() {
        return rows;
    }

    boolean isRectangular() {
        return ragged.isEmpty();
    }

    void requireRectangular() {
        ScanException.refuseIf(
                !isRectangular(), "has " + ragged + ", but " + columns + " in its first row; export it again");
    }

    public double[] first(int wanted) {
        ScanException.refuseIf(
                wanted > count,
                "has " + count + " numbers where its header announces " + wanted + "; copy or export it again");
        return Arrays.copyOf(values, wanted);
    }

    double[] column(int column) {
        double[] some = new double[rows];
        for (int row = 0; row < rows; row++) {
            some[row] = values[row * columns + column];
        }
        return some;
    }
}
