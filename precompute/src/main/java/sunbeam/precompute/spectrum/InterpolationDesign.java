package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.Comparator;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.optics.CoherenceWindow;

/**
 * Design of an interpolation that replaces a Gaussian of the frequency by a few taps on a grid:
 *
 * <pre>exp(-(f - f_j)^2 / (2 deviation^2)) = sum_m phi(f - m) K(m - f_j), all in grid steps</pre>
 *
 * <p>phi is a Kaiser-Bessel kernel that the GPU evaluates at a few grid points m around f. K spreads the DFT bins onto the grid beforehand;
 * it is the Gaussian with phi divided out of its transform (the deconvolution of gridding: Jackson et al. 1991; Greengard and Lee 2004).
 * The error is aliasing, small because the Gaussian's transform, the coherence window, fades before the kernel's.
 *
 * @param deviation standard deviation of the Gaussian in grid steps
 * @param beta shape parameter of phi
 * @param error largest difference between both sides, relative to the Gaussian, over the skirt; measured
 */
public record InterpolationDesign(double deviation, int taps, double beta, double error) {
    private static final int FEWEST_TAPS = 3;
    private static final int MOST_TAPS = 10;
    // On finer grids the Gaussian bends less between samples, which makes its skirts exact.
    private static final double[] DEVIATIONS = {1.6, 2, 2.5, 3, 4};
    // These err least of 1.5 to 3.2, both in the middle and on the skirts.
    private static final double[] BETA_PER_TAP = {2.5, 2.65, 2.8, 2.95};
    /** End of a Gaussian, in standard deviations: exp(-7.5^2 / 2) = 6e-13. */
    public static final double GAUSS_REACH = 7.5;

    /** Returns the fewest taps, and of those the coarsest grid, within a relative error over a skirt in standard deviations. */
    public static InterpolationDesign within(double tolerance, double skirt) {
        double finest = DEVIATIONS[DEVIATIONS.length - 1];
        return first(
                tolerance,
                IntStream.rangeClosed(FEWEST_TAPS, MOST_TAPS)
                        // If the finest grid fails, so do the coarser ones.
                        .filter(taps -> best(finest, taps, skirt).error <= tolerance)
                        .boxed()
                        .flatMap(taps -> Arrays.stream(DEVIATIONS).mapToObj(grid -> best(grid, taps, skirt))));
    }

    /** Returns the design that has the coarsest grid, to save memory, and of those the fewest taps. */
    public static InterpolationDesign compact(double tolerance, double skirt) {
        return first(
                tolerance,
                Arrays.stream(DEVIATIONS)
                        .boxed()
                        .flatMap(grid -> IntStream.rangeClosed(FEWEST_TAPS, MOST_TAPS)
                                .mapToObj(taps -> best(grid, taps, skirt))));
    }

    private static InterpolationDesign first(double tolerance, Stream<InterpolationDesign> tried) {
        return tried.filter(design -> design.error <= tolerance)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no interpolation keeps " + tolerance));
    }

    public static InterpolationDesign best(double deviation, int taps, double skirt) {
        return Arrays.stream(BETA_PER_TAP)
                .map(perTap -> perTap * taps)
                .mapToObj(beta -> new InterpolationDesign(
                        deviation, taps, beta, new Spread(deviation, taps, beta).largestError(skirt)))
                .min(Comparator.comparingDouble(InterpolationDesign::error))
                .orElseThrow();
    }

    /** Returns phi at a distance in grid steps; 0 from taps / 2 on. */
    public double kernel(double distance) {
        return new KaiserBessel(taps, beta).value(distance);
    }

    Spread spread() {
        return new Spread(deviation, taps, beta);
    }

    static final class Spread {
        private static final int SPECTRUM_SAMPLES = 256;
        // Distances at which errors are measured, in standard deviations.
        private static final double DISTANCE_STEP = 0.6;
        // Between two grid points.
        private static final int POSITIONS = 4;

        private final KaiserBessel kernel;
        private final double deviation;
        private final double[] spectrum = new double[SPECTRUM_SAMPLES + 1];

        Spread(double deviation, int taps, double beta) {
            this.kernel = new KaiserBessel(taps, beta);
            this.deviation = deviation;
            for (int i = 0; i <= SPECTRUM_SAMPLES; i++) {
                double frequency = 0.5 * i / SPECTRUM_SAMPLES;
                double end = i == 0 || i == SPECTRUM_SAMPLES ? 0.5 : 1;
                double gauss = CoherenceWindow.amplitude(2 * Math.PI * deviation * frequency);
                spectrum[i] = end * gauss / kernel.transform(frequency);
            }
        }

        double reach() {
            return GAUSS_REACH * deviation + 0.5 * kernel.taps();
        }

        double value(double distance) {
            if (Math.abs(distance) > reach()) {
                return 0;
            }
            // cos(i angle) by rotation; a few hundred steps lose two digits of sixteen.
            double angle = Math.PI * distance / SPECTRUM_SAMPLES;
            double stepCosine = Math.cos(angle);
            double stepSine = Math.sin(angle);
            double cosine = 1;
            double sine = 0;
            double sum = 0;
            for (double value : spectrum) {
                sum += value * cosine;
                double next = cosine * stepCosine - sine * stepSine;
                sine = sine * stepCosine + cosine * stepSine;
                cosine = next;
            }
            return sum / SPECTRUM_SAMPLES * deviation * Math.sqrt(2 * Math.PI);
        }

        /** Returns the largest error, relative to the Gaussian, over a skirt in its standard deviations. */
        private double largestError(double skirt) {
            double largest = 0;
            int distances = (int) Math.ceil(skirt / DISTANCE_STEP);
            for (int i = 0; i <= distances; i++) {
                for (int place = 0; place < POSITIONS; place++) {
                    double bin = (double) place / POSITIONS;
                    // The offset of f from the grid point below varies with the distance.
                    double f = bin + skirt * i / distances * deviation;
                    double gauss = CoherenceWindow.amplitude((f - bin) / deviation);
                    largest = Math.max(largest, Math.abs(interpolated(f, bin) / gauss - 1));
                }
            }
            return largest;
        }

        double interpolated(double f, double bin) {
            double sum = 0;
            double half = 0.5 * kernel.taps();
            for (long m = (long) Math.ceil(f - half); m <= f + half; m++) {
                sum += kernel.value(f - m) * value(m - bin);
            }
            return sum;
        }
    }

    /**
     * Kaiser-Bessel interpolation kernel over {@code taps} grid points with the shape parameter beta (Kaiser 1966; Jackson et al. 1991):
     *
     * <pre>phi(x) = I0(beta sqrt(1 - (2 x / taps)^2)) / I0(beta),  |x| &lt; taps / 2</pre>
     */
    public record KaiserBessel(int taps, double beta, double peak) {
        public KaiserBessel(int taps, double beta) {
            this(taps, beta, besselI0(beta));
        }

        public double value(double x) {
            double ratio = 2 * x / taps;
            return ratio * ratio >= 1 ? 0 : besselI0(beta * Math.sqrt(1 - ratio * ratio)) / peak;
        }

        /** Returns the Fourier transform at a frequency in cycles per grid step. */
        public double transform(double frequency) {
            double turns = Math.PI * taps * frequency;
            double square = beta * beta - turns * turns;
            double root = Math.sqrt(Math.abs(square));
            double shape = root < 1e-6 ? 1 : (square > 0 ? Math.sinh(root) : Math.sin(root)) / root;
            return shape * taps / peak;
        }

        /** I0 by its power series; all terms are positive, so none cancel. */
        private static double besselI0(double x) {
            double term = 1;
            double sum = 1;
            for (int k = 1; term > 1e-17 * sum; k++) {
                term *= x * x / (4.0 * k * k);
                sum += term;
            }
            return sum;
        }
    }

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
                        distance -> CoherenceWindow.amplitude(distance / deviation),
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
}
