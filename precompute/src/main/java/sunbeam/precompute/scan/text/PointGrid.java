package sunbeam.precompute.scan.text;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.text.Text;

/**
 * Grid on which points x y z lie, which a file lists in any order.
 *
 * @param axisY axis of the rows; row 0 has the largest y
 * @param heights heights row by row, NaN for cells without a point
 */
record PointGrid(Axis axisX, Axis axisY, double[] heights) {
    /** In pitches. Files round coordinates; those closer than twice this share of the largest gap belong to one grid line. */
    private static final double MOST_OFF = 0.05;

    private static final double MOST_MISSING = 0.5;

    /** Equidistant coordinates in ascending order, in the file's unit. */
    record Axis(double first, double pitch, int count) {
        int index(double coordinate) {
            return (int) Math.round((coordinate - first) / pitch);
        }

        /** Fits an axis to coordinates in any order; empty if they are not equidistant or all equal. */
        static Optional<Axis> of(double[] coordinates) {
            double[] sorted = coordinates.clone();
            Arrays.sort(sorted);
            double least = sorted[0];
            double range = sorted[sorted.length - 1] - least;
            if (!(range > 0) || !Double.isFinite(range)) {
                return Optional.empty();
            }
            double largest = 0;
            for (int i = 1; i < sorted.length; i++) {
                largest = Math.max(largest, sorted[i] - sorted[i - 1]);
            }
            double sameLine = 2 * MOST_OFF * largest;
            int steps = (int) IntStream.range(1, sorted.length)
                    .filter(i -> sorted[i] - sorted[i - 1] > sameLine)
                    .count();
            Axis axis = new Axis(least, range / steps, steps + 1);
            return Arrays.stream(sorted).allMatch(axis::isOnLine) ? Optional.of(axis) : Optional.empty();
        }

        private boolean isOnLine(double coordinate) {
            double position = (coordinate - first) / pitch;
            return Math.abs(position - Math.rint(position)) <= MOST_OFF;
        }
    }

    /**
     * Fits a grid to points; empty if they lie on none.
     *
     * @throws ScanException if two points share a cell
     */
    static Optional<PointGrid> of(double[] x, double[] y, double[] z) {
        Optional<Axis> columns = Axis.of(x);
        Optional<Axis> rows = columns.isEmpty() ? Optional.empty() : Axis.of(y);
        if (rows.isEmpty()) {
            return Optional.empty();
        }
        Axis axisX = columns.get();
        Axis axisY = rows.get();
        long cells = (long) axisX.count * axisY.count;
        if (cells > x.length / MOST_MISSING) {
            return Optional.empty();
        }
        double[] heights = new double[(int) cells];
        boolean[] taken = new boolean[heights.length];
        Arrays.fill(heights, Double.NaN);
        for (int i = 0; i < x.length; i++) {
            int row = axisY.count - 1 - axisY.index(y[i]);
            int cell = row * axisX.count + axisX.index(x[i]);
            if (taken[cell]) {
                throw new ScanException(Text.format(
                        "has two points at x = %s, y = %s; export the scan as a matrix or as .gwy", x[i], y[i]));
            }
            taken[cell] = true;
            heights[cell] = z[i];
        }
        return Optional.of(new PointGrid(axisX, axisY, heights));
    }
}
