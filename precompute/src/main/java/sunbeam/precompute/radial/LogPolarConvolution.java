package sunbeam.precompute.radial;

import java.util.Arrays;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.color.WavelengthNodes;

/**
 * Colors along a ray of (u, v) at equal steps of ln |(u, v)|, in several slices of w. A wavelength sees the frequency (u, v) /
 * lambda, and ln |f| = ln |(u, v)| - ln lambda: for each term of the power the integral over wavelengths is a convolution
 * of its values along the ray with the color matching functions times the term's coefficient, which Fourier transforms do
 * for all places and wavelengths at once. In double precision; its error is that of {@link AverageProjection}, which is nothing where no
 * order shines.
 *
 * <p>Immutable; each thread takes a {@link Line} of its own.
 */
final class LogPolarConvolution {
    private static final int COLORS = 3;

    private final int count;
    private final AverageProjection interpolation;
    private final LogGrid knots;
    private final int padded;
    private final int terms;
    private final int slices;
    // Of each pair of results, X and Y of a slice or Z of two: per term real and imaginary parts of the kernel's
    // transform.
    private final double[][][][] kernels;

    /** Coefficients of the power's terms. */
    @FunctionalInterface
    interface Coefficients {
        /** One value a term, for a wavelength in metres and the |w| of a slice. */
        double[] at(double wavelength, double depth);
    }

    /**
     * Prepares kernels.
     *
     * @param first ln |(u, v)| of the first place
     * @param count of the places
     * @param stride steps of the wavelengths' logarithm from one place to the next
     * @param wavelengths at equal steps of their logarithm
     * @param depths |w| of the slices
     */
    LogPolarConvolution(
            double first,
            int count,
            int stride,
            WavelengthNodes wavelengths,
            double[] depths,
            Coefficients coefficients) {
        int nodes = wavelengths.count();
        this.count = count;
        this.interpolation = new AverageProjection(stride, nodes);
        this.slices = depths.length;
        int asked = length(count, stride, nodes);
        this.padded = padded(asked);
        double shortest = Math.log(wavelengths.wavelengths()[0]);
        double step = (Math.log(wavelengths.wavelengths()[nodes - 1]) - shortest) / (nodes - 1);
        // The last coefficient counts what the first place sees at the longest wavelength.
        double lowest = first - shortest - (interpolation.firstMiddle() + (interpolation.knots() - 1) * stride) * step;
        this.knots = new LogGrid(lowest, stride * step, asked);
        double[][][] atNodes = new double[slices][nodes][];
        for (int slice = 0; slice < slices; slice++) {
            for (int i = 0; i < nodes; i++) {
                atNodes[slice][i] = coefficients.at(wavelengths.wavelengths()[i], depths[slice]);
            }
        }
        this.terms = atNodes[0][0].length;
        this.kernels = new double[pairs()][terms][][];
        for (int pair = 0; pair < pairs(); pair++) {
            int[] parts = parts(pair);
            for (int m = 0; m < terms; m++) {
                double[][] kernel = new double[2][];
                for (int part = 0; part < 2; part++) {
                    kernel[part] = kernel(parts[part], m, atNodes, wavelengths);
                }
                FastFourierTransformer.transformInPlace(kernel, DftNormalization.STANDARD, TransformType.FORWARD);
                kernels[pair][m] = kernel;
            }
        }
    }

    /** Places that a transform has at least. */
    static int length(int count, int stride, int nodes) {
        return count + AverageProjection.knots(stride, nodes) - 1;
    }

    /** Places that a transform has. */
    static int padded(int length) {
        return Math.max(2, Integer.highestOneBit(length - 1) << 1);
    }

    /** Coefficients of a result's B-splines for a term, and zeros. */
    private double[] kernel(int result, int term, double[][][] atNodes, WavelengthNodes wavelengths) {
        int slice = result / COLORS;
        if (slice >= slices) {
            return new double[padded];
        }
        double[] values = new double[wavelengths.count()];
        for (int i = 0; i < values.length; i++) {
            values[i] = atNodes[slice][i][term] * wavelengths.weights()[i][result % COLORS];
        }
        return Arrays.copyOf(interpolation.coefficients(values), padded);
    }

    /** Pairs of results, of which a complex transform gives two at once: X and Y of each slice, then Z of slices two by two. */
    private int pairs() {
        return slices + (slices + 1) / 2;
    }

    /** Results of a pair: slice times three plus color; beyond the last slice there is none. */
    private int[] parts(int pair) {
        if (pair < slices) {
            return new int[] {COLORS * pair, COLORS * pair + 1};
        }
        int slice = 2 * (pair - slices);
        return new int[] {COLORS * slice + 2, COLORS * (slice + 1) + 2};
    }

    /** Places on a ray. */
    int count() {
        return count;
    }

    /** Where on a ray averages of the powers are asked for. */
    LogGrid knots() {
        return knots;
    }

    /**
     * Room for one ray.
     *
     * @param stride values of each knot
     */
    Line line(int stride) {
        return new Line(stride);
    }

    /** One ray at a time; belongs to a thread. */
    final class Line {
        private final int stride;
        private final double[] averages;
        private final double[][] transformed = new double[2][padded];
        private final double[][][] spectra = new double[terms][2][padded];
        private final double[][] sum = new double[2][padded];

        private Line(int stride) {
            this.stride = stride;
            this.averages = new double[stride * knots.count()];
        }

        /**
         * Colors along a ray.
         *
         * @param batch that the ray is one of
         * @param target takes them: {@code [slice * 3 + color][first + place]}
         */
        void colors(RayBatch batch, double angle, float[][] target, int first) {
            batch.averages(angle, averages);
            transformTerms();
            for (int pair = 0; pair < pairs(); pair++) {
                int[] parts = parts(pair);
                multiply(kernels[pair]);
                FastFourierTransformer.transformInPlace(sum, DftNormalization.STANDARD, TransformType.INVERSE);
                put(sum[0], target[parts[0]], first);
                if (parts[1] < target.length) {
                    put(sum[1], target[parts[1]], first);
                }
            }
        }

        private void put(double[] from, float[] to, int first) {
            for (int i = 0; i < count; i++) {
                to[first + i] = (float) from[interpolation.knots() - 1 + i];
            }
        }

        /** Two real terms in a complex transform; where there is no second, it is zero. */
        private void transformTerms() {
            for (int m = 0; m < terms; m += 2) {
                take(m, transformed[0]);
                take(m + 1, transformed[1]);
                FastFourierTransformer.transformInPlace(transformed, DftNormalization.STANDARD, TransformType.FORWARD);
                double[] re = transformed[0];
                double[] im = transformed[1];
                for (int k = 0; k < padded; k++) {
                    int mirrored = k == 0 ? 0 : padded - k;
                    spectra[m][0][k] = 0.5 * (re[k] + re[mirrored]);
                    spectra[m][1][k] = 0.5 * (im[k] - im[mirrored]);
                    if (m + 1 < terms) {
                        spectra[m + 1][0][k] = 0.5 * (im[k] + im[mirrored]);
                        spectra[m + 1][1][k] = 0.5 * (re[mirrored] - re[k]);
                    }
                }
            }
        }

        /** Averages of a term, and zeros; where there is no such term, zeros alone. */
        private void take(int term, double[] to) {
            Arrays.fill(to, 0);
            if (term < terms) {
                for (int knot = 0; knot < knots.count(); knot++) {
                    to[knot] = averages[knot * stride + term];
                }
            }
        }

        private void multiply(double[][][] kernel) {
            Arrays.fill(sum[0], 0);
            Arrays.fill(sum[1], 0);
            int m = 0;
            for (; m + 1 < terms; m += 2) {
                addProducts(spectra[m], kernel[m], spectra[m + 1], kernel[m + 1], sum);
            }
            if (m < terms) {
                addProduct(spectra[m], kernel[m], sum);
            }
        }
    }

    private static void addProduct(double[][] a, double[][] b, double[][] sum) {
        double[] ar = a[0];
        double[] ai = a[1];
        double[] br = b[0];
        double[] bi = b[1];
        double[] real = sum[0];
        double[] imag = sum[1];
        for (int k = 0; k < real.length; k++) {
            real[k] += ar[k] * br[k] - ai[k] * bi[k];
            imag[k] += ar[k] * bi[k] + ai[k] * br[k];
        }
    }

    /** Two at once: the sums are read and written half as often. */
    private static void addProducts(double[][] a, double[][] b, double[][] c, double[][] d, double[][] sum) {
        double[] ar = a[0];
        double[] ai = a[1];
        double[] br = b[0];
        double[] bi = b[1];
        double[] cr = c[0];
        double[] ci = c[1];
        double[] dr = d[0];
        double[] di = d[1];
        double[] real = sum[0];
        double[] imag = sum[1];
        for (int k = 0; k < real.length; k++) {
            real[k] += ar[k] * br[k] - ai[k] * bi[k] + cr[k] * dr[k] - ci[k] * di[k];
            imag[k] += ar[k] * bi[k] + ai[k] * br[k] + cr[k] * di[k] + ci[k] * dr[k];
        }
    }
}
