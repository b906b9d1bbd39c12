package sunbeam.precompute.fault;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;

/** By how much each row lies above the one before it: the median over columns, and how far the columns stray from that. */
final class RowSteps {
    // Columns that are looked at, evenly spread: a median of so many is known to a twelfth of the spread.
    private static final int MOST_COLUMNS = 256;
    // Of a Gaussian's deviation over its median distance from the middle.
    private static final double GAUSSIAN = 1.4826;

    private final double[] steps;
    private final double[] means;
    private final double[] spreads;
    private final double largest;

    RowSteps(Measured scan) {
        int pairs = Math.max(0, scan.rows() - 1);
        steps = new double[pairs];
        means = new double[pairs];
        spreads = new double[pairs];
        int stride = (scan.columns() + MOST_COLUMNS - 1) / MOST_COLUMNS;
        IntStream.range(0, pairs).parallel().forEach(row -> {
            double[] differences = IntStream.range(0, scan.columns() / stride)
                    .mapToDouble(i -> scan.at(i * stride, row + 1) - scan.at(i * stride, row))
                    .filter(Double::isFinite)
                    .toArray();
            steps[row] = median(differences);
            means[row] = Arrays.stream(differences).average().orElse(Double.NaN);
            for (int i = 0; i < differences.length; i++) {
                differences[i] = Math.abs(differences[i] - steps[row]);
            }
            spreads[row] = GAUSSIAN * median(differences);
        });
        largest = IntStream.range(0, scan.rows())
                .parallel()
                .mapToDouble(row -> largestOf(scan, row))
                .max()
                .orElse(0);
    }

    private static double largestOf(Measured scan, int row) {
        double most = 0;
        for (int column = 0; column < scan.columns(); column++) {
            double height = Math.abs(scan.at(column, row));
            most = height > most && height < Double.POSITIVE_INFINITY ? height : most;
        }
        return most;
    }

    /** Of values that are sorted by it; NaN of none. */
    static double median(double[] values) {
        Arrays.sort(values);
        int middle = values.length / 2;
        if (values.length == 0) {
            return Double.NaN;
        }
        return values.length % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    }

    /** Robust deviation of values about their median. */
    static double spreadOf(double[] values) {
        double middle = median(values.clone());
        return GAUSSIAN
                * median(Arrays.stream(values)
                        .map(value -> Math.abs(value - middle))
                        .toArray());
    }

    int pairs() {
        return steps.length;
    }

    /** From a row to the next below it, metres; NaN where one of them is missing. */
    double step(int row) {
        return steps[row];
    }

    /** The same by the mean over the columns: of a saw that slips sideways it is nothing, while most columns rise by the same. */
    double meanStep(int row) {
        return means[row];
    }

    /** Robust deviation of that over the columns, metres; 0 beyond the scan and where a row is missing. */
    double spread(int row) {
        return row < 0 || row >= spreads.length || Double.isNaN(spreads[row]) ? 0 : spreads[row];
    }

    /** The largest height, up or down, metres. */
    double largest() {
        return largest;
    }

    /**
     * What columns stray by from a row to the next where the rows are measured: the median over such pairs.
     *
     * @param repeated rows that are the ones before once more
     * @param others rows that are no measurement
     * @return metres, 0 where there is no such pair
     */
    double typicalSpread(BitSet repeated, BitSet others) {
        double median = median(IntStream.range(0, pairs())
                .filter(row -> !repeated.get(row + 1) && !others.get(row) && !others.get(row + 1))
                .mapToDouble(this::spread)
                .toArray());
        return Double.isNaN(median) ? 0 : median;
    }
}
