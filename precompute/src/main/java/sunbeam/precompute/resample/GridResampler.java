package sunbeam.precompute.resample;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Resamples DFT bins onto a grid, separably.
 *
 * @param alongX weights along x
 * @param alongY weights along y
 */
public record GridResampler(AxisResampler alongX, AxisResampler alongY) {

    /** Axis that runs fastest. */
    public enum Order {
        ROWS,
        COLUMNS
    }

    /** Returns the number of samples of one field. */
    public int size() {
        return Math.multiplyExact(alongX.grid().count(), alongY.grid().count());
    }

    /**
     * Resamples real fields of bins (rows of ascending y bins), interleaved by sample.
     *
     * @param fields at most {@code stride}
     * @param target output
     * @param stride distance of neighboring samples along the fastest axis
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
