package sunbeam.precompute.fourier;

import java.util.Arrays;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.numerics.KaiserBessel;

/**
 * Inverse DFT of one period, limited to a band of bins: X_j = (1/N) sum_n x_n exp(+2 pi i n j / N) for the bins j of a {@link Band}:
 * Commons Math's FFT where N is a power of two, a nonuniform FFT over it otherwise. The band may be longer than N, since the DFT is
 * periodic. Immutable and thread-safe.
 */
public final class BandTransform {
    private final int length;
    private final Band band;
    private final Nonuniform nonuniform;

    public BandTransform(int length, Band band) {
        this.length = length;
        this.band = band;
        boolean powerOfTwo = length > 1 && Integer.bitCount(length) == 1;
        this.nonuniform = powerOfTwo ? null : new Nonuniform(length, band);
    }

    public Band band() {
        return band;
    }

    public ComplexVector workspace() {
        return ComplexVector.zeros(length);
    }

    /** Transforms the first N values of {@code work} (overwritten) and writes the band to {@code target}, in steps of {@code stride}. */
    public void transform(ComplexVector work, ComplexVector target, int offset, int stride) {
        if (nonuniform == null) {
            double[][] data = {work.real(), work.imaginary()};
            FastFourierTransformer.transformInPlace(data, DftNormalization.STANDARD, TransformType.INVERSE);
            for (int m = 0, index = offset; m < band.count(); m++, index += stride) {
                int bin = Math.floorMod(band.first() + m, length);
                target.real()[index] = work.real()[bin];
                target.imaginary()[index] = work.imaginary()[bin];
            }
        } else {
            nonuniform.transform(work, 1.0 / length, target, offset, stride);
        }
    }

    /**
     * Nonuniform FFT for a band of the DFT of a sequence of any length. The sequence is convolved with a Kaiser-Bessel kernel onto a grid,
     * whose size is a power of two and at least twice the band's. The grid's FFT is divided by the kernel's transform (Fessler and Sutton, IEEE
     * Transactions on Signal Processing 51 (2003)).
     *
     * <pre>X_j = sum_n x_n exp(+2 pi i j n / N)</pre>
     *
     * <p>Errors are some 1e-14 of the largest bin. Immutable and thread-safe.
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
        private final ComplexVector turn;
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
            this.turn = ComplexVector.zeros(length);
            for (int n = 0; n < length; n++) {
                double angle = 2 * Math.PI * Math.floorMod((long) middle * n, (long) length) / length;
                turn.real()[n] = Math.cos(angle);
                turn.imaginary()[n] = Math.sin(angle);
            }
            this.gains = new double[band.count()];
            Arrays.setAll(gains, m -> gridSize / kernel.transform((double) (band.first() + m - middle) / gridSize));
        }

        /** Transforms the first N values and writes the band, times a factor, to the target in steps of {@code stride}. */
        void transform(ComplexVector samples, double factor, ComplexVector target, int offset, int stride) {
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
                turned.real()[i] = re * turn.real()[n] - im * turn.imaginary()[n];
                turned.imaginary()[i] = re * turn.imaginary()[n] + im * turn.real()[n];
            }
            return turned;
        }
    }
}
