package sunbeam.precompute.fourier;

import java.util.Arrays;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.numerics.KaiserBessel;

/**
 * A band of the DFT of a sequence of any length: the sequence is blurred onto a grid of a power of two, at least twice as many places as there
 * are bins, and their transform divided by the blur's (Fessler and Sutton, IEEE Transactions on Signal Processing 51 (2003)).
 *
 * <pre>X_j = sum_n x_n exp(+2 pi i j n / N)</pre>
 *
 * Errors are some 1e-14 of the largest bin. Immutable and safe for use by several threads.
 */
final class GridTransform {
    // The kernel leaves some hundred times exp(-pi d) of what lies beyond the frequencies of the grid.
    private static final double DIGITS = 12;

    private final int length;
    private final Band band;
    private final int middle;
    private final int places;
    private final int margin;
    // Of each place: the first sample that lends to it, counted from the margin on, and what it and those behind it
    // lend.
    private final int[] first;
    private final double[][] weights;
    // exp(2 pi i middle n / N), which moves the band to the middle.
    private final ComplexVector turn;
    // Of each bin.
    private final double[] gains;

    /** For sequences of a length, at least 1. */
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

    /**
     * Transforms the first N values of a vector and writes the band, times a factor, from {@code offset} on in steps of {@code stride}.
     */
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

    /** With the band in the middle, and on either side as many samples of the next periods as kernels reach. */
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
