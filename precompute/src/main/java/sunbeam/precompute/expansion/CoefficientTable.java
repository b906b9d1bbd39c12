package sunbeam.precompute.expansion;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * Real coefficients c_n(zeta) of an {@link Expansion}, sampled at equal steps of the phase zeta in radians. Shaders interpolate them by
 * parabolas through the nearest three samples.
 *
 * @param values {@code [term][sample]}
 */
public record CoefficientTable(double minimumPhase, double maximumPhase, float[][] values) {

    // Interpolation error of functions of bandwidth 1 and magnitude 1, per radian of the range of phases: a third of
    // float32's rounding of the phase and of the coefficients. Weak orders, small differences of large terms, see both
    // errors.
    private static final double LARGEST_ERROR = 2e-8;
    // The parabola through three samples errs by step^3 / PARABOLA.
    private static final double PARABOLA = 16;
    private static final int FEWEST_SAMPLES = 64;

    public static CoefficientTable sampled(Expansion expansion) {
        return sampled(
                expansion.minimumPhase(), expansion.maximumPhase(), 1, expansion.terms(), expansion::coefficients);
    }

    /**
     * Returns the samples of functions of the phase between two phases in radians.
     *
     * @param bandwidth largest frequency of the functions, in radians per radian of phase
     * @param terms number of functions
     */
    public static CoefficientTable sampled(
            double low, double high, double bandwidth, int terms, DoubleFunction<double[]> coefficientsAt) {
        int samples = sampleCount(high - low, bandwidth);
        float[][] values = new float[terms][samples];
        IntStream.range(0, samples).parallel().forEach(i -> {
            double[] coefficients = coefficientsAt.apply(low + (high - low) * i / (samples - 1));
            for (int n = 0; n < terms; n++) {
                values[n][i] = (float) coefficients[n];
            }
        });
        return new CoefficientTable(low, high, values);
    }

    /** Returns the number of samples over the phases of an expansion, for the layout of a texture. */
    public static int sampleCount(Expansion expansion, double bandwidth) {
        return sampleCount(expansion.maximumPhase() - expansion.minimumPhase(), bandwidth);
    }

    private static int sampleCount(double range, double bandwidth) {
        double step = Math.cbrt(PARABOLA * LARGEST_ERROR * Math.max(1, range)) / bandwidth;
        return (int) Math.max(FEWEST_SAMPLES, Math.ceil(range / step) + 1);
    }

    public int samples() {
        return values[0].length;
    }

    public int terms() {
        return values.length;
    }
}
