package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.util.Locale;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/** The numbers of a text, counted before memory is taken for them. */
final class TextNumbers {
    private final TextBytes file;
    private final TextHead head;
    private final long columns;
    private final long rows;
    private final long count;
    /** The first line with another number of numbers than the first has; 0 when there is none. */
    private final long raggedLine;

    private final long raggedCount;

    private TextNumbers(TextBytes file, TextHead head, long columns, long rows, long count, long[] ragged) {
        this.file = file;
        this.head = head;
        this.columns = columns;
        this.rows = rows;
        this.count = count;
        this.raggedLine = ragged[0];
        this.raggedCount = ragged[1];
    }

    /**
     * Counts, in constant memory.
     *
     * @throws ScanException when there are too many, or something that is no number
     */
    static TextNumbers count(TextBytes file, TextHead head) throws IOException {
        NumberStream numbers = stream(file, head);
        long[] ragged = new long[2];
        long columns = 0;
        long rows = 0;
        long inRow = 0;
        long count = 0;
        long line = 0;
        while (numbers.next()) {
            if (numbers.firstOfLine() && rows > 0) {
                columns = rows == 1 ? inRow : columns;
                note(ragged, columns, inRow, line);
                inRow = 0;
            }
            rows += numbers.firstOfLine() ? 1 : 0;
            line = numbers.line();
            inRow++;
            // Three numbers a point.
            if (++count > 3 * ScanLimits.MOST_SAMPLES) {
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "has more than %d numbers, more than can be used; crop the scan",
                        3 * ScanLimits.MOST_SAMPLES));
            }
        }
        columns = rows == 1 ? inRow : columns;
        note(ragged, columns, inRow, line);
        return new TextNumbers(file, head, columns, rows, count, ragged);
    }

    private static void note(long[] ragged, long columns, long inRow, long line) {
        if (ragged[0] == 0 && inRow != columns) {
            ragged[0] = line;
            ragged[1] = inRow;
        }
    }

    private static NumberStream stream(TextBytes file, TextHead head) throws IOException {
        return new NumberStream(
                file.stream(head.offset()), head.decimalComma(), head.header().size() + 1L);
    }

    /** Numbers of the first line. */
    long columns() {
        return columns;
    }

    /** Lines with numbers. */
    long rows() {
        return rows;
    }

    long count() {
        return count;
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

    /** All numbers in their order. */
    double[] read() throws IOException {
        double[] all = new double[Math.toIntExact(count)];
        NumberStream numbers = stream(file, head);
        for (int i = 0; i < all.length && numbers.next(); i++) {
            all[i] = numbers.value();
        }
        return all;
    }

    /** The numbers of each column. */
    double[][] readColumns(int several) throws IOException {
        ScanLimits.requireMemory(
                rows, Double.BYTES * (several + 1), Runtime.getRuntime().maxMemory());
        double[][] all = new double[several][Math.toIntExact(rows)];
        NumberStream numbers = stream(file, head);
        for (int i = 0; i < several * rows && numbers.next(); i++) {
            all[i % several][i / several] = numbers.value();
        }
        return all;
    }
}
