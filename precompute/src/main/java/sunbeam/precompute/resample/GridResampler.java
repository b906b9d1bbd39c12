package sunbeam.precompute.resample;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Resamples bins of two axes onto a grid of both.
 *
 * @param alongX weights along x
 * @param alongY weights along y
 */
public record GridResampler(AxisResampler alongX, AxisResampler alongY) {

    /** Which axis runs fastest. */
    public enum Order {
        /** x. */
        ROWS,
        /** y. */
        COLUMNS
    }

    /** Number of samples of one field. */
    public int size() {
        return Math.multiplyExact(alongX.grid().count(), alongY.grid().count());
    }

    /**
     * Real fields of bins (rows of ascending y bins) to samples, in which the fields lie side by side.
     *
     * @param fields at most {@code stride}
     * @param target samples are stored here
     * @param stride distance of neighboring samples along the axis that runs fastest
     */
    public void resample(double[][] fields, float[] target, int stride, Order order) {
        double[][] halves = new double[fields.length][];
        Arrays.setAll(halves, i -> alongX(fields[i]));
        int columns = alongX.grid().count();
        int rows = alongY.grid().count();
        IntStream.range(0, rows).parallel().forEach(row -> {
            double[][] sums = new double[fields.length][];
            Arrays.setAll(sums, i -> row(halves[i], row));
            for (int column = 0; column < columns; column++) {
                int sample = order == Order.COLUMNS ? column * rows + row : row * columns + column;
                for (int i = 0; i < fields.length; i++) {
                    target[sample * stride + i] = (float) sums[i][column];
                }
            }
        });
    }

    /** Rows of bins to rows of samples. */
    private double[] alongX(double[] bins) {
        int binColumns = alongX.band().count();
        int columns = alongX.grid().count();
        double[] half = new double[alongY.band().count() * columns];
        IntStream.range(0, alongY.band().count()).parallel().forEach(binRow -> {
            for (int column = 0; column < columns; column++) {
                double[] weights = alongX.weights()[column];
                int first = binRow * binColumns + alongX.firstBin()[column];
                double sum = 0;
                for (int j = 0; j < weights.length; j++) {
                    sum += weights[j] * bins[first + j];
                }
                half[binRow * columns + column] = sum;
            }
        });
        return half;
    }

    private double[] row(double[] half, int row) {
        int columns = alongX.grid().count();
        double[] weights = alongY.weights()[row];
        double[] sums = new double[columns];
        for (int j = 0; j < weights.length; j++) {
            int first = (alongY.firstBin()[row] + j) * columns;
            for (int column = 0; column < columns; column++) {
                sums[column] += weights[j] * half[first + column];
            }
        }
        return sums;
    }
}
