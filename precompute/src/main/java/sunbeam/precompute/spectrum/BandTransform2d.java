package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.function.BiConsumer;
import java.util.function.ObjIntConsumer;
import java.util.stream.IntStream;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.spectrum.InterpolationDesign.KaiserBessel;

/**
 * Two-dimensional inverse DFT of one period of a field, limited to a band of bins along each axis. The field is seen from above: column
 * indices grow with x, row indices with -y, so that
 *
 * <pre>F[jy, jx] = 1/(columns rows) sum field(column, row) exp(+2 pi i (jx column / columns - jy row / rows))</pre>
 *
 * Rows of the result are in ascending order of jy, columns in ascending order of jx. Runs on all cores.
 */
public final class BandTransform2d {
    private final int rows;
    private final Line alongX;
    private final Line alongY;

    /** Samples of a complex or a real field. Must be thread-safe. */
    @FunctionalInterface
    public interface RowSource {
        void fill(int row, double[] real, double[] imaginary);
    }

    public BandTransform2d(int columns, int rows, Band bandX, Band bandY) {
        this.rows = rows;
        this.alongX = new Line(columns, bandX);
        // Bin jy of y is bin -jy of the row index: descending row bins are ascending y bins.
        this.alongY = new Line(rows, Band.of(-bandY.last(), -bandY.first()));
    }

    /** Returns {@code bandY.count() * bandX.count()} bins, row by row. */
    public ComplexVector transform(RowSource source) {
        int width = alongX.band().count();
        int height = alongY.band().count();
        ComplexVector half = ComplexVector.zeros(Math.multiplyExact(rows, width));
        IntStream.range(0, rows).parallel().forEach(row -> {
            ComplexVector work = alongX.workspace();
            source.fill(row, work.real(), work.imaginary());
            alongX.transform(work, half, row * width, 1);
        });
        ComplexVector result = ComplexVector.zeros(Math.multiplyExact(height, width));
        forEachColumn(
                half, width, (column, work) -> alongY.transform(work, result, (height - 1) * width + column, -width));
        return result;
    }

    private void forEachColumn(ComplexVector half, int width, BiConsumer<Integer, ComplexVector> visitor) {
        IntStream.range(0, width).parallel().forEach(column -> {
            ComplexVector work = alongY.workspace();
            for (int row = 0; row < rows; row++) {
                work.real()[row] = half.real()[row * width + column];
                work.imaginary()[row] = half.imaginary()[row * width + column];
            }
            visitor.accept(column, work);
        });
    }

    /**
     * Returns the squared magnitudes of the bins of a real field, for bands that are symmetric about 0 and less than half the samples wide
     * on each side. Bins (jx, jy) and (-jx, -jy) are conjugate: two rows are transformed as one, and only columns with jx >= 0.
     *
     * @param source fills a row of samples; must be thread-safe
     */
    public double[] powers(ObjIntConsumer<double[]> source) {
        int reachX = alongX.band().last();
        int width = reachX + 1;
        ComplexVector half = ComplexVector.zeros(Math.multiplyExact(rows, width));
        IntStream.range(0, (rows + 1) / 2).parallel().forEach(pair -> transformPair(source, 2 * pair, half));
        int count = alongX.band().count();
        double[] powers = new double[Math.multiplyExact(count, alongY.band().count())];
        forEachColumn(half, width, (column, work) -> {
            ComplexVector bins = ComplexVector.zeros(alongY.band().count());
            alongY.transform(work, bins, 0, 1);
            for (int i = 0; i < bins.length(); i++) {
                double square = bins.real()[i] * bins.real()[i] + bins.imaginary()[i] * bins.imaginary()[i];
                powers[(bins.length() - 1 - i) * count + reachX + column] = square;
                powers[i * count + reachX - column] = square;
            }
        });
        return powers;
    }

    private void transformPair(ObjIntConsumer<double[]> source, int row, ComplexVector half) {
        ComplexVector work = alongX.workspace();
        source.accept(work.real(), row);
        boolean two = row + 1 < rows;
        if (two) {
            source.accept(work.imaginary(), row + 1);
        }
        int reachX = alongX.band().last();
        ComplexVector bins = ComplexVector.zeros(2 * reachX + 1);
        alongX.transform(work, bins, 0, 1);
        for (int jx = 0, at = row * (reachX + 1); jx <= reachX; jx++, at++) {
            double real = bins.real()[reachX + jx];
            double imaginary = bins.imaginary()[reachX + jx];
            double mirroredReal = bins.real()[reachX - jx];
            double mirroredImaginary = bins.imaginary()[reachX - jx];
            half.real()[at] = 0.5 * (real + mirroredReal);
            half.imaginary()[at] = 0.5 * (imaginary - mirroredImaginary);
            if (two) {
                half.real()[at + reachX + 1] = 0.5 * (imaginary + mirroredImaginary);
                half.imaginary()[at + reachX + 1] = 0.5 * (mirroredReal - real);
            }
        }
    }

    /**
     * Inverse DFT of one period, X_j = (1/N) sum_n x_n exp(+2 pi i n j / N), for the bins j of a {@link Band}, which may be longer than N:
     * Commons Math's FFT where N is a power of two, a nonuniform FFT over it otherwise. Thread-safe.
     */
    record Line(int length, Band band, Nonuniform nonuniform) {
        Line(int length, Band band) {
            this(length, band, length > 1 && Integer.bitCount(length) == 1 ? null : new Nonuniform(length, band));
        }

        ComplexVector workspace() {
            return ComplexVector.zeros(length);
        }

        /** Overwrites the first N values of {@code work}; writes the band to {@code target}, in steps of {@code stride}. */
        void transform(ComplexVector work, ComplexVector target, int offset, int stride) {
            if (nonuniform == null) {
                double[][] data = {work.real(), work.imaginary()};
                FastFourierTransformer.transformInPlace(data, DftNormalization.STANDARD, TransformType.INVERSE);
                for (int m = 0, index = offset; m < band.count(); m++, index += stride) {
                    int bin = Math.floorMod(band.first() + m, length);
                    target.real()[index] = work.real()[bin];
                    target.imaginary()[index] = work.imaginary()[bin];
                }
            } else {
                nonuniform.transform(work, target, offset, stride);
            }
        }

        /**
         * Nonuniform FFT for a band of the DFT of a sequence of any length, X_j = sum_n x_n exp(+2 pi i j n / N). A Kaiser-Bessel kernel
         * convolves the sequence onto a grid, whose size is a power of two and at least twice the band's; the grid's FFT is divided by the
         * kernel's transform (Fessler and Sutton, IEEE Transactions on Signal Processing 51 (2003)). Errors are some 1e-14 of the largest
         * bin. Thread-safe.
         */
        private static final class Nonuniform {
            // Aliases from beyond the grid's frequencies are some 100 exp(-pi ACCURACY) of their amplitude.
            private static final double ACCURACY = 12;

            private final int length;
            private final Band band;
            private final int middle;
            private final int gridSize;
            private final int margin;
            // Per grid point: first sample within the kernel's reach, and the weights of the samples from there on.
            private final int[] first;
            private final double[][] weights;
            // exp(2 pi i middle n / N), which moves the band's middle to bin 0.
            private final double[][] turn;
            // Per bin: reciprocal of the kernel's transform.
            private final double[] gains;

            Nonuniform(int length, Band band) {
                this.length = length;
                this.band = band;
                this.middle = Math.floorDiv(band.first() + band.last(), 2);
                this.gridSize = Math.max(2, Integer.highestOneBit(2 * band.count() - 1) << 1);
                double share = (double) band.count() / gridSize;
                int taps = (int) Math.ceil(ACCURACY / Math.sqrt(1 - share));
                KaiserBessel kernel = new KaiserBessel(taps, Math.PI * taps * (1 - 0.5 * share));
                double samplesPerPoint = (double) length / gridSize;
                double reach = 0.5 * kernel.taps() * samplesPerPoint;
                this.margin = (int) Math.ceil(reach);
                this.first = new int[gridSize];
                this.weights = new double[gridSize][];
                for (int point = 0; point < gridSize; point++) {
                    int begin = (int) Math.ceil(point * samplesPerPoint - reach);
                    int end = (int) Math.floor(point * samplesPerPoint + reach);
                    first[point] = begin + margin;
                    weights[point] = new double[end - begin + 1];
                    for (int n = begin; n <= end; n++) {
                        weights[point][n - begin] = kernel.value(point - n / samplesPerPoint);
                    }
                }
                this.turn = new Band(0, length).phases(length, middle);
                this.gains = new double[band.count()];
                Arrays.setAll(gains, m -> gridSize / kernel.transform((double) (band.first() + m - middle) / gridSize));
            }

            void transform(ComplexVector samples, ComplexVector target, int offset, int stride) {
                ComplexVector turned = turned(samples);
                double[] re = turned.real();
                double[] im = turned.imaginary();
                double[][] grid = new double[2][gridSize];
                for (int point = 0; point < gridSize; point++) {
                    double real = 0;
                    double imaginary = 0;
                    int at = first[point];
                    for (double weight : weights[point]) {
                        real += weight * re[at];
                        imaginary += weight * im[at];
                        at++;
                    }
                    grid[0][point] = real;
                    grid[1][point] = imaginary;
                }
                FastFourierTransformer.transformInPlace(grid, DftNormalization.STANDARD, TransformType.INVERSE);
                double factor = 1.0 / length;
                for (int m = 0, index = offset; m < gains.length; m++, index += stride) {
                    int bin = band.first() + m - middle & gridSize - 1;
                    target.real()[index] = factor * gains[m] * grid[0][bin];
                    target.imaginary()[index] = factor * gains[m] * grid[1][bin];
                }
            }

            /** The band's middle moves to bin 0; the sequence is extended periodically by the margin on both sides. */
            private ComplexVector turned(ComplexVector samples) {
                ComplexVector turned = ComplexVector.zeros(length + 2 * margin);
                for (int i = 0; i < turned.length(); i++) {
                    int n = i >= margin && i < margin + length ? i - margin : Math.floorMod(i - margin, length);
                    double re = samples.real()[n];
                    double im = samples.imaginary()[n];
                    turned.real()[i] = re * turn[0][n] - im * turn[1][n];
                    turned.imaginary()[i] = re * turn[1][n] + im * turn[0][n];
                }
                return turned;
            }
        }
    }
}
