package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;

/** Resamples DFT bins onto a grid, separably. */
public record GridResampler(Axis alongX, Axis alongY) {
    /** Weights {@code [sample][bin]} from bins to a grid: sample i is sum_j weight(f_i - f_j) bin_j from {@code firstBin} on. */
    public record Axis(int bins, int[] firstBin, double[][] weights) {
        /** Returns weights for later interpolation: the Gaussian with the kernel divided out; step in cycles per meter. */
        public static Axis forInterpolation(
                Band grid, double step, PowerSpectrum.Axis bins, InterpolationDesign design) {
            InterpolationDesign.Spread spread = design.spread();
            return of(grid, step, bins, spread::value, spread.reach());
        }

        /** Returns weights for samples that are read at grid points only: the plain Gaussian; sigma in cycles per meter. */
        public static Axis forGridPoints(Band grid, double step, PowerSpectrum.Axis bins, double sigma) {
            double deviation = sigma / step;
            return of(
                    grid,
                    step,
                    bins,
                    distance -> Math.exp(-0.5 * Math.pow(distance / deviation, 2)),
                    InterpolationDesign.GAUSS_REACH * deviation);
        }

        private static Axis of(
                Band grid, double step, PowerSpectrum.Axis bins, DoubleUnaryOperator weight, double reach) {
            int[] firstBin = new int[grid.count()];
            double[][] weights = new double[grid.count()][];
            double stepsPerBin = 1 / (bins.period() * step);
            for (int i = 0; i < grid.count(); i++) {
                double position = (grid.first() + i) / stepsPerBin;
                int low = (int) Math.max(bins.first(), Math.ceil(position - reach / stepsPerBin));
                int high = (int) Math.min(bins.last(), Math.floor(position + reach / stepsPerBin));
                firstBin[i] = low - bins.first();
                weights[i] = new double[Math.max(0, high - low + 1)];
                for (int j = 0; j < weights[i].length; j++) {
                    weights[i][j] = weight.applyAsDouble((position - low - j) * stepsPerBin);
                }
            }
            return new Axis(bins.count(), firstBin, weights);
        }
    }

    public enum Order {
        ROWS,
        COLUMNS
    }

    public int size() {
        return Math.multiplyExact(alongX.weights.length, alongY.weights.length);
    }

    /** Resamples real fields {@code [field][bin]}, rows of ascending y; the target interleaves them, {@code stride} per sample. */
    public void resample(double[][] fields, float[] target, int stride, Order order) {
        double[][] halves = Arrays.stream(fields).map(this::alongX).toArray(double[][]::new);
        int columns = alongX.weights.length;
        int rows = alongY.weights.length;
        IntStream.range(0, rows).parallel().forEach(row -> {
            for (int i = 0; i < fields.length; i++) {
                double[] sums = row(halves[i], row);
                for (int column = 0; column < columns; column++) {
                    int sample = order == Order.COLUMNS ? column * rows + row : row * columns + column;
                    target[sample * stride + i] = (float) sums[column];
                }
            }
        });
    }

    private double[] alongX(double[] bins) {
        int binColumns = alongX.bins();
        int columns = alongX.weights.length;
        double[] half = new double[alongY.bins() * columns];
        IntStream.range(0, alongY.bins()).parallel().forEach(binRow -> {
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
        int columns = alongX.weights.length;
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
