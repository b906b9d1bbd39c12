package sunbeam.precompute.scan.text;

import sunbeam.precompute.scan.ScanException;

/**
 * A first column or row that counts up evenly beside heights that do not: places or numbers of rows that were exported with the
 * heights. In a spectrum they are a step, and they make the scan a sample too wide.
 */
final class CountedLines {
    private static final int FEWEST = 8;
    // Of the step: places are rounded when they are written.
    private static final double ROUNDING = 0.2;

    private CountedLines() {}

    /**
     * Looks at a matrix.
     *
     * @param heights row by row
     * @throws ScanException where a line of it are no heights
     */
    static void refuse(double[] heights, int columns) {
        int rows = heights.length / columns;
        // The corner may be anything.
        boolean firstColumn = columns > 1 && counts(heights, columns, columns, rows - 1);
        if (firstColumn && columns == 2) {
            throw new ScanException(
                    "has two columns, places and heights: a profile, not a scan of a surface; export the whole image");
        }
        if (firstColumn && !counts(heights, columns + 1, columns, rows - 1)) {
            throw told("column");
        }
        boolean firstRow = rows > 1 && counts(heights, 1, 1, columns - 1);
        if (firstRow && !counts(heights, columns + 1, 1, columns - 1)) {
            throw told("row");
        }
    }

    private static ScanException told(String line) {
        return new ScanException(
                "has a first " + line + " that counts evenly, as places or numbers of rows do, beside others that do"
                        + " not; remove it, so that only heights are left");
    }

    /** Whether numbers at even distances are as even themselves. */
    private static boolean counts(double[] numbers, int first, int stride, int count) {
        if (count < FEWEST) {
            return false;
        }
        double step = (numbers[first + (count - 1) * stride] - numbers[first]) / (count - 1);
        if (!(Math.abs(step) > 0) || !Double.isFinite(step)) {
            return false;
        }
        for (int i = 0; i < count; i++) {
            if (!(Math.abs(numbers[first + i * stride] - numbers[first] - i * step) <= ROUNDING * Math.abs(step))) {
                return false;
            }
        }
        return true;
    }
}
