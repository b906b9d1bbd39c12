package sunbeam.precompute.scan.text;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.scan.ScanException;

/**
 * Points x y z whose x and y lie on a grid, in any order; a cell without a point is a missing sample.
 *
 * @param axisX of the columns
 * @param axisY of the rows; row 0 has the largest y
 * @param heights row by row, NaN where no point is
 */
record PointGrid(Axis axisX, Axis axisY, double[] heights) {
    /** Largest distance of a coordinate from its grid line, in pitches; files round coordinates to a few digits. */
    private static final double MOST_OFF = 0.05;

    private static final double MOST_MISSING = 0.5;

    /**
     * Equidistant coordinates.
     *
     * @param first smallest coordinate
     * @param pitch distance of neighbours
     * @param count how many
     */
    record Axis(double first, double pitch, int count) {
        int index(double coordinate) {
            return (int) Math.round((coordinate - first) / pitch);
        }

        /** The axis that all coordinates lie on; nothing when they lie on none or on a single one. */
        static Optional<Axis> of(double[] coordinates) {
            double least = Double.POSITIVE_INFINITY;
            double largest = Double.NEGATIVE_INFINITY;
            for (double coordinate : coordinates) {
                if (!Double.isFinite(coordinate)) {
                    return Optional.empty();
                }
                least = Math.min(least, coordinate);
                largest = Math.max(largest, coordinate);
            }
            double range = largest - least;
            double step = medianStep(coordinates, 1e-9 * range);
            if (!(range > 0) || !(step > 0) || range / step > coordinates.length) {
                return Optional.empty();
            }
            int intervals = (int) Math.round(range / step);
            Axis axis = new Axis(least, range / intervals, intervals + 1);
            for (double coordinate : coordinates) {
                double position = (coordinate - least) / axis.pitch;
                if (Math.abs(position - Math.rint(position)) > MOST_OFF) {
                    return Optional.empty();
                }
            }
            return Optional.of(axis);
        }

        /** Of the steps between neighbours in the file that are no standstill. */
        private static double medianStep(double[] coordinates, double standstill) {
            double[] steps = new double[coordinates.length];
            int count = 0;
            for (int i = 1; i < coordinates.length; i++) {
                double step = Math.abs(coordinates[i] - coordinates[i - 1]);
                if (step > standstill) {
                    steps[count++] = step;
                }
            }
            Arrays.sort(steps, 0, count);
            return count == 0 ? 0 : steps[count / 2];
        }
    }

    /**
     * The grid that points lie on; nothing when they lie on none.
     *
     * @throws ScanException when two points share a place, or most places have none
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
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "has two points at x = %s, y = %s; export the scan as a matrix or as .gwy",
                        x[i],
                        y[i]));
            }
            taken[cell] = true;
            heights[cell] = z[i];
        }
        return Optional.of(new PointGrid(axisX, axisY, heights));
    }
}
