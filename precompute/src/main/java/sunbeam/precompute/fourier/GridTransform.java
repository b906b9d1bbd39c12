package sunbeam.precompute.fourier;

import java.util.Arrays;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.numerics.KaiserBessel;

/**
 * Nonuniform FFT for a band of the DFT of a sequence of any length. Blurs the sequence onto a grid of a power of two, at least twice the
 * band, transforms it, and divides by the blur's transform (Fessler and Sutton, IEEE Transactions on Signal Processing 51 (2003)).
 *
 * <pre>X_j = sum_n x_n exp(+2 pi i j n / N)</pre>
 *
 * <p>Errors are some 1e-14 of the largest bin. Immutable and thread-safe.
 */
final class GridTransform {
    // The kernel leaves some hundred times exp(-pi d) of what lies beyond the frequencies of the grid.
    private static final double DIGITS = 12;

    private final int length;
    private final Band band;
    private final int middle;
    private final int places;
    private final int margin;
    // Per grid point: first sample within reach, counted from the margin on, and the weights of the samples from there.
    private final int[] first;
    private final double[][] weights;
    // exp(2 pi i middle n / N), which moves the band's middle to bin 0
    private final ComplexVector turn;
    // per bin: inverse of the blur's transform
    private final double[] gains;

    GridTransform(int length, Band band) {
        this.length = length;
        this.band = band;
        this.middle = Math.floorDiv(band.first() + band.last(), 2);
        this.places = Math.max(2, Integer.highestOneBit(2 * band.count() - 1) << 1);
        double share = (double) band.count() / places;
        int taps = (int) Math.ceil(DIGITS / Math.sqrt(1 - share));
        KaiserBessel kernel = new KaiserBessel(taps, Math.PI * taps * (1 - 0.5 * share));
        double perPlace = (double) length / places;
        double reach = 0.5 * kernel.taps() * perPlace;
        this.margin = (int) Math.ceil(reach);
        this.first = new int[places];
        this.weights = new double[places][];
        for (int place = 0; place < places; place++) {
            int begin = (int) Math.ceil(place * perPlace - reach);
            int end = (int) Math.floor(place * perPlace + reach);
            first[place] = begin + margin;
            weights[place] = new double[end - begin + 1];
            for (int n = begin; n <= end; n++) {
                weights[place][n - begin] = kernel.value(place - n / perPlace);
            }
        }
        this.turn = ComplexVector.zeros(length);
        for (int n = 0; n < length; n++) {
            double angle = 2 * Math.PI * Math.floorMod((long) middle * n, (long) length) / length;
            turn.real()[n] = Math.cos(angle);
            turn.imaginary()[n] = Math.sin(angle);
        }
        this.gains = new double[band.count()];
        Arrays.setAll(gains, m -> places / kernel.transform((double) (band.first() + m - middle) / places));
    }

    /** Transforms the first N values of a vector and writes the band, times a factor, from {@code offset} on in steps of {@code stride}. */
    void transform(ComplexVector samples, double factor, ComplexVector target, int offset, int stride) {
        ComplexVector turned = turned(samples);
        double[] re = turned.real();
        double[] im = turned.imaginary();
        double[][] grid = new double[2][places];
        for (int place = 0; place < places; place++) {
            double real = 0;
            double imaginary = 0;
            int at = first[place];
            for (double weight : weights[place]) {
                real += weight * re[at];
                imaginary += weight * im[at];
                at++;
            }
            grid[0][place] = real;
            grid[1][place] = imaginary;
        }
        FastFourierTransformer.transformInPlace(grid, DftNormalization.STANDARD, TransformType.INVERSE);
        for (int m = 0, index = offset; m < gains.length; m++, index += stride) {
            int bin = band.first() + m - middle & places - 1;
            target.real()[index] = factor * gains[m] * grid[0][bin];
            target.imaginary()[index] = factor * gains[m] * grid[1][bin];
        }
    }

    /** Moves the band's middle to bin 0 and extends the sequence periodically by the kernel's reach. */
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
