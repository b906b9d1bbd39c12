package sunbeam.precompute.colortable;

import java.util.Arrays;
import org.apache.commons.math3.analysis.polynomials.PolynomialFunction;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.spectrum.PowerSpectrum;

/**
 * Evaluates colors along a ray of (u, v) at equal steps of ln |(u, v)|, in several slices of w, by the log-polar convolution: a wavelength
 * sees f = (u, v) / lambda, and ln |f| = ln |(u, v)| - ln lambda. So for each term of the power the integral over wavelengths is a
 * convolution of the term along the ray with the color matching function times the term's coefficient; one FFT, in double precision, serves
 * all positions and wavelengths. The error is that of {@link AverageProjection}. Not thread-safe.
 */
final class LogPolarConvolution {
    private static final int COLORS = 3;

    private final int count;
    private final AverageProjection interpolation;
    private final WindowedSpectrum.Knots knots;
    private final int padded;
    private final int terms;
    private final int slices;
    private final int stride;
    // [pair][term]. A pair is two real results of one complex transform: X and Y of a slice, or Z of two slices.
    private final double[][][][] kernels;
    private final double[] averages;
    private final double[][] transformed;
    private final double[][][] spectra;
    private final double[][] sum;

    /** Positions begin at ln |(u, v)| {@code first}; their wavelengths have equal steps of ln lambda; depths are |w| of the slices. */
    LogPolarConvolution(double first, LogRadialBand.Positions positions, double[] depths, PowerSpectrum spectrum) {
        WavelengthNodes wavelengths = positions.wavelengths();
        int nodes = wavelengths.count();
        this.count = positions.count();
        this.interpolation = new AverageProjection(positions.stride(), nodes);
        this.slices = depths.length;
        this.stride = spectrum.stride();
        int length = positions.length();
        this.padded = Math.max(2, Integer.highestOneBit(length - 1) << 1);
        double shortest = Math.log(wavelengths.wavelengths()[0]);
        double step = (Math.log(wavelengths.wavelengths()[nodes - 1]) - shortest) / (nodes - 1);
        // A kernel's last coefficient belongs to the frequency of the first position at the longest wavelength.
        // The center of the first average lies before the sequence.
        int lastCenter = (interpolation.knots - 1 - AverageProjection.BEFORE) * positions.stride();
        double lowest = first - shortest - lastCenter * step;
        this.knots = new WindowedSpectrum.Knots(lowest, positions.stride() * step, length);
        double[][][] atNodes = new double[slices][nodes][];
        for (int slice = 0; slice < slices; slice++) {
            for (int i = 0; i < nodes; i++) {
                atNodes[slice][i] = spectrum.coefficients(wavelengths.wavelengths()[i], depths[slice]);
            }
        }
        // An even number, padded by zeros as those of PowerSpectrum: terms are transformed and multiplied in pairs.
        this.terms = (atNodes[0][0].length + 1) / 2 * 2;
        this.averages = new double[stride * length];
        this.transformed = new double[2][padded];
        this.spectra = new double[terms][2][padded];
        this.sum = new double[2][padded];
        this.kernels = new double[pairs()][terms][][];
        for (int pair = 0; pair < pairs(); pair++) {
            for (int m = 0; m < terms; m++) {
                kernels[pair][m] = new double[][] {
                    kernel(target(2 * pair), m, atNodes, wavelengths),
                    kernel(target(2 * pair + 1), m, atNodes, wavelengths)
                };
                transform(kernels[pair][m], TransformType.FORWARD);
            }
        }
    }

    private static void transform(double[][] complex, TransformType direction) {
        FastFourierTransformer.transformInPlace(complex, DftNormalization.STANDARD, direction);
    }

    private double[] kernel(int target, int term, double[][][] atNodes, WavelengthNodes wavelengths) {
        int slice = target / COLORS;
        if (slice >= slices || term >= atNodes[slice][0].length) {
            return new double[padded];
        }
        double[] values = new double[wavelengths.count()];
        Arrays.setAll(values, i -> atNodes[slice][i][term] * wavelengths.weights()[i][target % COLORS]);
        return Arrays.copyOf(interpolation.coefficients(values), padded);
    }

    /** Complex transforms, each of two results: of X and Y of each slice, then of Z two by two. */
    private int pairs() {
        return (COLORS * slices + 1) / 2;
    }

    /** Returns slice * 3 + color of a result; the last pair's second one may lie beyond the last slice. */
    private int target(int result) {
        int ofZ = result - 2 * slices;
        return ofZ < 0 ? COLORS * (result / 2) + result % 2 : COLORS * ofZ + 2;
    }

    WindowedSpectrum.Knots knots() {
        return knots;
    }

    /** @param output colors, {@code [slice * 3 + color][first + position]} */
    void colors(WindowedSpectrum.RayBatch batch, double angle, float[][] output, int first) {
        batch.averages(angle, averages);
        transformTerms();
        for (int pair = 0; pair < pairs(); pair++) {
            multiply(kernels[pair]);
            transform(sum, TransformType.INVERSE);
            for (int i = 0; i < 2; i++) {
                int to = target(2 * pair + i);
                for (int position = 0; to < output.length && position < count; position++) {
                    output[to][first + position] = (float) sum[i][interpolation.knots - 1 + position];
                }
            }
        }
    }

    private void transformTerms() {
        for (int m = 0; m < terms; m += 2) {
            for (int i = 0; i < 2; i++) {
                Arrays.fill(transformed[i], 0);
                for (int knot = 0; knot < knots.count(); knot++) {
                    transformed[i][knot] = averages[knot * stride + m + i];
                }
            }
            transform(transformed, TransformType.FORWARD);
            double[] re = transformed[0];
            double[] im = transformed[1];
            for (int k = 0; k < padded; k++) {
                int mirrored = k == 0 ? 0 : padded - k;
                spectra[m][0][k] = 0.5 * (re[k] + re[mirrored]);
                spectra[m][1][k] = 0.5 * (im[k] - im[mirrored]);
                spectra[m + 1][0][k] = 0.5 * (im[k] + im[mirrored]);
                spectra[m + 1][1][k] = 0.5 * (re[mirrored] - re[k]);
            }
        }
    }

    /** Adds two products at once, which halves the memory traffic of the sums. */
    private void multiply(double[][][] kernel) {
        double[] real = sum[0];
        double[] imag = sum[1];
        Arrays.fill(real, 0);
        Arrays.fill(imag, 0);
        for (int m = 0; m < terms; m += 2) {
            double[] ar = spectra[m][0];
            double[] ai = spectra[m][1];
            double[] br = kernel[m][0];
            double[] bi = kernel[m][1];
            double[] cr = spectra[m + 1][0];
            double[] ci = spectra[m + 1][1];
            double[] dr = kernel[m + 1][0];
            double[] di = kernel[m + 1][1];
            for (int k = 0; k < padded; k++) {
                real[k] += ar[k] * br[k] - ai[k] * bi[k] + cr[k] * dr[k] - ci[k] * di[k];
                imag[k] += ar[k] * bi[k] + ai[k] * br[k] + cr[k] * di[k] + ci[k] * dr[k];
            }
        }
    }

    /**
     * Projects a weight sequence s onto cubic B-spline averages of a function f: sum_i s_i f(i) = sum_k c_k avg_k(f), with one average at every
     * stride-th index. Between averages f is the polynomial of degree 11 that has the twelve averages around, so s may jump (as the light of a
     * filter does) where f is smooth; where s is smooth, f need not be. Immutable.
     */
    static final class AverageProjection {
        private static final int POINTS = 12;
        private static final int BEFORE = POINTS / 2 - 1;

        private final int stride;
        private final int knots;
        // [index in s modulo stride][average]: share of a value in the c_k of the twelve averages around.
        private final double[][] weights;

        AverageProjection(int stride, int length) {
            this.stride = stride;
            this.knots = knots(stride, length);
            this.weights = new double[stride][POINTS];
            for (int point = 0; point < POINTS; point++) {
                PolynomialFunction polynomial = withAverage(lagrange(point));
                for (int behind = 0; behind < stride; behind++) {
                    weights[behind][point] = polynomial.value((double) behind / stride);
                }
            }
        }

        /** Returns the Lagrange polynomial that is 1 at {@code point - BEFORE} and 0 at the other points. */
        private static PolynomialFunction lagrange(int point) {
            PolynomialFunction product = new PolynomialFunction(new double[] {1});
            for (int other = 0; other < POINTS; other++) {
                if (other != point) {
                    double slope = 1.0 / (point - other);
                    product = product.multiply(new PolynomialFunction(new double[] {(BEFORE - other) * slope, slope}));
                }
            }
            return product;
        }

        /** Returns the polynomial whose averages are given. Each iteration corrects two more degrees. */
        private static PolynomialFunction withAverage(PolynomialFunction averages) {
            PolynomialFunction polynomial = averages;
            for (int right = 2; right < POINTS; right += 2) {
                polynomial = polynomial.add(averages.subtract(overBox(overBox(overBox(overBox(polynomial))))));
            }
            return polynomial;
        }

        /** Averages over [x - 1/2, x + 1/2]: the sum over n of p^(2n)(x) (1/2)^(2n) / (2n + 1)!. */
        private static PolynomialFunction overBox(PolynomialFunction polynomial) {
            PolynomialFunction sum = polynomial;
            PolynomialFunction derivative = polynomial;
            double factor = 1;
            for (int n = 1; 2 * n < POINTS; n++) {
                derivative = derivative.polynomialDerivative().polynomialDerivative();
                factor /= 4.0 * (2 * n) * (2 * n + 1);
                sum = sum.add(derivative.multiply(new PolynomialFunction(new double[] {factor})));
            }
            return sum;
        }

        static int knots(int stride, int length) {
            return (length - 1) / stride + POINTS;
        }

        double[] coefficients(double[] sequence) {
            double[] coefficients = new double[knots];
            for (int i = 0; i < sequence.length; i++) {
                double[] shares = weights[i % stride];
                for (int point = 0; point < POINTS; point++) {
                    coefficients[i / stride + point] += sequence[i] * shares[point];
                }
            }
            return coefficients;
        }
    }
}
