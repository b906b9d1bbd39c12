package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/**
 * All numbers of a text.
 *
 * @param values in their order; only the first {@code count} are any
 * @param columns numbers of the first line
 * @param rows lines with numbers
 * @param raggedLine the first line with another number of numbers than the first has; 0 when there is none
 * @param raggedCount its numbers
 */
record TextNumbers(double[] values, int count, long columns, long rows, long raggedLine, long raggedCount) {
    private static final int FIRST_CAPACITY = 1 << 12;
    /** Three numbers a point. */
    private static final long MOST = 3 * ScanLimits.MOST_SAMPLES;

    /**
     * Reads; memory grows with what is there.
     *
     * @throws ScanException when there are too many, or something that is no number
     */
    static TextNumbers read(NumberStream numbers) throws IOException {
        double[] values = new double[FIRST_CAPACITY];
        int count = 0;
        long columns = 0;
        long rows = 0;
        long inRow = 0;
        long line = 0;
        long raggedLine = 0;
        long raggedCount = 0;
        for (boolean more = true; more; ) {
            more = numbers.next();
            if (rows > 0 && (!more || numbers.firstOfLine())) {
                columns = rows == 1 ? inRow : columns;
                if (raggedLine == 0 && inRow != columns) {
                    raggedLine = line;
                    raggedCount = inRow;
                }
                inRow = 0;
            }
            if (more) {
                values = count < values.length ? values : grown(values);
                values[count++] = numbers.value();
                rows += numbers.firstOfLine() ? 1 : 0;
                line = numbers.line();
                inRow++;
            }
        }
        return new TextNumbers(values, count, columns, rows, raggedLine, raggedCount);
    }

    private static double[] grown(double[] values) {
        long capacity = 2L * values.length;
        if (values.length >= MOST) {
            throw new ScanException(
                    String.format(Locale.ROOT, "has more than %d numbers, more than can be used; crop the scan", MOST));
        }
        ScanLimits.requireMemory(capacity, 0, Runtime.getRuntime().maxMemory());
        return Arrays.copyOf(values, (int) Math.min(MOST, capacity));
    }

    boolean isRectangular() {
        return raggedLine == 0;
    }

    /** @throws ScanException naming the line with more or fewer numbers than the first */
    void requireRectangular() {
        if (!isRectangular()) {
            throw new ScanException(String.format(
                    Locale.ROOT,
                    "has %d numbers in line %d, but %d in its first row; export it again",
                    raggedCount,
                    raggedLine,
                    columns));
        }
    }

    /** A copy of all. */
    double[] all() {
        return Arrays.copyOf(values, count);
    }

    /** A copy of one of several columns. */
    double[] column(int column) {
        double[] some = new double[Math.toIntExact(rows)];
        for (int row = 0; row < some.length; row++) {
            some[row] = values[Math.toIntExact(row * columns + column)];
        }
        return some;
    }
}
