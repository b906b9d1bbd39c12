package sunbeam.precompute.plan;

import java.util.Arrays;
import java.util.StringJoiner;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.analysis.polynomials.PolynomialFunctionLagrangeForm;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.spectrum.CoefficientTable;
import sunbeam.precompute.text.Text;

/** Arrays of several methods' shaders: color matching functions times the light's spectrum, and coefficients of an expansion. */
public final class ShaderArrays {
    private static final int PER_TEXEL = 4;
    private static final int TABLE_LAST = 400;
    private static final int PER_NANOMETER = 8;
    /** Eight samples per nanometer from 380 to 780 nm, both ends included. */
    private static final int SAMPLES = TABLE_LAST * PER_NANOMETER + 1;

    private ShaderArrays() {}

    public static ArrayLayout cieWeightsLayout() {
        return ArrayLayout.flat("cieWeights", SAMPLES, 2, 4).linear();
    }

    /** Returns the weights of shaders/include/spectrum.glsl, per meter of wavelength: smoothed (row 0), and the table's (narrow orders). */
    public static TableArray cieWeights(CieTable cie) {
        double norm = 1 / cie.integralOfY();
        float[] texels = new float[2 * 4 * SAMPLES];
        for (int c = 0; c < 3; c++) {
            double[] weights = smooth(cie, c);
            for (int i = 0; i < SAMPLES; i++) {
                texels[4 * i + c] = (float) (weights[i] * norm);
                double wavelength = CieTable.MINIMUM_WAVELENGTH + i * (1e-9 / PER_NANOMETER);
                texels[4 * (SAMPLES + i) + c] = (float) (cie.at(wavelength, c) * norm);
            }
        }
        return TableArray.of(cieWeightsLayout(), texels);
    }

    /**
     * Returns S xbar, S ybar or S zbar (channel 0, 1, 2) at each sample, not normalized. On the flanks of the color matching functions
     * linear interpolation lies up to 1.5e-3 above the smooth function; an integral averages this excess, nodes a nanometer or more apart
     * do not. So (w[i-1] + 10 w[i] + w[i+1]) / 12 adds the chords' mean excess, and a cubic spline interpolates (Catmull and Rom 1974).
     */
    private static double[] smooth(CieTable cie, int channel) {
        double[] filtered = new double[TABLE_LAST + 1];
        for (int i = 0; i <= TABLE_LAST; i++) {
            filtered[i] = (at(cie, i - 1, channel) + 10 * at(cie, i, channel) + at(cie, i + 1, channel)) / 12;
        }
        double[] result = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            int left = Math.min(TABLE_LAST - 1, i / PER_NANOMETER);
            result[i] = cubic(filtered, left, (double) i / PER_NANOMETER - left);
        }
        return result;
    }

    /** Extrapolates linearly beyond the band's ends. */
    private static double at(CieTable cie, int nanometer, int channel) {
        int inside = Math.min(TABLE_LAST, Math.max(0, nanometer));
        double value = cie.at(CieTable.MINIMUM_WAVELENGTH + inside * 1e-9, channel);
        int inwards = Integer.compare(inside, nanometer);
        return inwards == 0
                ? value
                : 2 * value - cie.at(CieTable.MINIMUM_WAVELENGTH + (inside + inwards) * 1e-9, channel);
    }

    private static double cubic(double[] values, int left, double t) {
        double from = values[left];
        double to = values[left + 1];
        double before = left == 0 ? 2 * from - to : values[left - 1];
        double after = left + 2 > TABLE_LAST ? 2 * to - from : values[left + 2];
        double slope = 0.5 * (to - before);
        double bend = before - 2.5 * from + 2 * to - 0.5 * after;
        double twist = 0.5 * (after - before) + 1.5 * (from - to);
        return from + t * (slope + t * (bend + t * twist));
    }

    public static ArrayLayout wavelengthsLayout(WavelengthNodes nodes) {
        return ArrayLayout.flat("wavelengthNodes", nodes.count(), 1, 4);
    }

    /** Returns the fixed wavelengths and their weights, for shaders/include/wavelengths.glsl. */
    public static TableArray wavelengths(WavelengthNodes nodes) {
        float[] texels = new float[4 * nodes.count()];
        for (int i = 0; i < nodes.count(); i++) {
            texels[4 * i] = (float) nodes.wavelengths()[i];
            for (int c = 0; c < 3; c++) {
                texels[4 * i + 1 + c] = (float) nodes.weights()[i][c];
            }
        }
        return TableArray.of(wavelengthsLayout(nodes), texels);
    }

    /** Defines the source of coefficients in shaders/include/expansion.glsl: an array of samples, or the closed form of Taylor. */
    public static void define(ShaderTables.Builder tables, boolean sampled, int terms) {
        tables.define("EXPANSION_TAYLOR", 0).define("EXPANSION_SAMPLED", 1);
        tables.define("EXPANSION", sampled ? "EXPANSION_SAMPLED" : "EXPANSION_TAYLOR")
                .define("TERMS", terms);
    }

    public static ArrayLayout coefficientsLayout(String sampler, int samples, int terms) {
        return ArrayLayout.flat(sampler, samples, (terms + PER_TEXEL - 1) / PER_TEXEL, PER_TEXEL);
    }

    /** Each texel has {@value #PER_TEXEL} terms, for shaders that sum all terms in order. */
    public static TableArray coefficients(String sampler, CoefficientTable coefficients) {
        int samples = coefficients.samples();
        ArrayLayout layout = coefficientsLayout(sampler, samples, coefficients.terms());
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            for (int i = 0; i < samples; i++) {
                texels[((n / PER_TEXEL) * samples + i) * PER_TEXEL + n % PER_TEXEL] =
                        (float) coefficients.values()[i][n];
            }
        }
        return TableArray.of(layout, texels);
    }

    public static ArrayLayout singleLayout(String sampler, int samples, int terms) {
        return ArrayLayout.flat(sampler, samples, terms, PER_TEXEL);
    }

    /** Each texel has a term's coefficient at the previous, this and the next sample, so that one texel fetch interpolates it. */
    public static TableArray singleCoefficients(String sampler, CoefficientTable coefficients) {
        int samples = coefficients.samples();
        ArrayLayout layout = singleLayout(sampler, samples, coefficients.terms());
        float[] texels = new float[layout.floatsPerLayer()];
        for (int n = 0; n < coefficients.terms(); n++) {
            float[] floats = coefficients.floats(n);
            for (int i = 1; i < samples - 1; i++) {
                System.arraycopy(floats, i - 1, texels, (n * samples + i) * PER_TEXEL, 3);
            }
        }
        return TableArray.of(layout, texels);
    }

    /** Returns {offset, scale}: a phase in radians belongs to sample offset + scale times phase, counted from 0. */
    public static double[] phaseMap(CoefficientTable coefficients) {
        double scale = (coefficients.samples() - 1.0) / (coefficients.maximumPhase() - coefficients.minimumPhase());
        return new double[] {-scale * coefficients.minimumPhase(), scale};
    }

    /** Returns {offset, scale} of the map from a value to its texture coordinate. */
    public static double[] textureMap(double first, double last, int samples) {
        double scale = (samples - 1.0) / samples / (last - first);
        return new double[] {0.5 / samples - scale * first, scale};
    }

    /**
     * Interpolation kernel as polynomials (shaders/method/grid_tables.glsl): the weight of each tap as a function of x = 2 fraction - 1 in [-1,
     * 1], through the kernel at Chebyshev nodes. Unlike a table's, their float32 rounding is relative to each tap's own weight: on a bright
     * order's skirt the outermost tap reads a sample a thousand times brighter than the result.
     */
    public record KernelPolynomials(double[][] coefficients) {
        // A sample a thousand times brighter than the result adds an error of 2e-6, less than the finest tolerance.
        private static final double LARGEST_ERROR = 2e-9;
        // Smooth kernels need fewer coefficients.
        private static final int MOST_POWERS = 16;
        private static final int CHECKED_INTERVALS = 64;

        /** Returns polynomials of the least degree near a kernel of distances in samples, which is smooth up to {@code taps / 2}. */
        public static KernelPolynomials of(int taps, DoubleUnaryOperator kernel) {
            for (int powers = 4; powers <= MOST_POWERS; powers++) {
                int count = powers;
                KernelPolynomials polynomials = new KernelPolynomials(IntStream.range(0, taps)
                        .mapToObj(tap -> through(x -> kernel.applyAsDouble(distance(taps, tap, x)), count))
                        .toArray(double[][]::new));
                if (polynomials.largestError(kernel) <= LARGEST_ERROR) {
                    return polynomials;
                }
            }
            throw new IllegalArgumentException("no polynomial of " + MOST_POWERS + " powers is near the kernel");
        }

        private static double distance(int taps, int tap, double x) {
            return (x + 1) / 2 + 0.5 * taps - 1 - tap;
        }

        private static double[] through(DoubleUnaryOperator function, int powers) {
            double[] nodes = IntStream.range(0, powers)
                    .mapToDouble(i -> Math.cos(Math.PI * (i + 0.5) / powers))
                    .toArray();
            double[] values = Arrays.stream(nodes).map(function).toArray();
            return new PolynomialFunctionLagrangeForm(nodes, values).getCoefficients();
        }

        private double largestError(DoubleUnaryOperator kernel) {
            double largest = 0;
            for (int tap = 0; tap < coefficients.length; tap++) {
                for (int i = 0; i <= CHECKED_INTERVALS; i++) {
                    double x = 2.0 * i / CHECKED_INTERVALS - 1;
                    // The kernel may be discontinuous at its edge.
                    double exact = kernel.applyAsDouble(distance(coefficients.length, tap, x * (1 - 1e-12)));
                    largest = Math.max(largest, Math.abs(weight(tap, x) - exact));
                }
            }
            return largest;
        }

        double weight(int tap, double x) {
            double sum = 0;
            for (int power = powers() - 1; power >= 0; power--) {
                sum = sum * x + coefficients[tap][power];
            }
            return sum;
        }

        int powers() {
            return coefficients[0].length;
        }

        /** Defines TAPS, and KERNEL_AT_PLACE, an array of the weights by Horner's rule. */
        public void defineIn(ShaderTables.Builder tables) {
            StringJoiner weights = new StringJoiner(", ", "float[](", ")");
            for (double[] tap : coefficients) {
                StringBuilder weight = new StringBuilder(literal(tap[powers() - 1]));
                for (int power = powers() - 2; power >= 0; power--) {
                    weight.insert(0, "(").append(") * place + ").append(literal(tap[power]));
                }
                weights.add(weight);
            }
            tables.define("TAPS", coefficients.length).define("KERNEL_AT_PLACE", weights);
        }

        private static String literal(double coefficient) {
            return Text.format("(%.9e)", coefficient);
        }
    }
}
