package sunbeam.precompute.expansion;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * Coefficients c_n(zeta) sampled at equal steps of the phase, real.
 *
 * @param minimumPhase zeta of the first sample
 * @param maximumPhase zeta of the last sample
 * @param values {@code [term][sample]}
 */
public record CoefficientTable(double minimumPhase, double maximumPhase, float[][] values) {

    // Linear interpolation between samples a step apart errs by step^2 / 8 of the coefficient: 2e-8 at this step, less
    // than
    // float32 rounds. Weak orders are small differences of large terms, and see the error of these.
    private static final double STEP = 4e-4;
    private static final double COARSE_STEP = 2.8e-3;
    private static final int FEWEST = 64;
    // The widest texture that every driver of OpenGL 3.3 allows; beyond, the error grows to 3e-6 at 5 um of relief.
    private static final int MOST = 16384;

    /** Samples all coefficients of an expansion over its phases. */
    public static CoefficientTable sampled(Expansion expansion) {
        return sampled(expansion, sampleCount(expansion));
    }

    /** Samples all coefficients of an expansion over its phases, so many times. */
    public static CoefficientTable sampled(Expansion expansion, int samples) {
        return sampled(
                expansion.minimumPhase(),
                expansion.maximumPhase(),
                expansion.terms(),
                expansion::coefficients,
                samples);
    }

    /** Samples functions of the phase, so many times. */
    public static CoefficientTable sampled(
            double low, double high, int terms, DoubleFunction<double[]> coefficientsAt, int samples) {
        float[][] values = new float[terms][samples];
        IntStream.range(0, samples).parallel().forEach(i -> {
            double[] coefficients = coefficientsAt.apply(low + (high - low) * i / (samples - 1));
            for (int n = 0; n < terms; n++) {
                values[n][i] = (float) coefficients[n];
            }
        });
        return new CoefficientTable(low, high, values);
    }

    /** Samples that an expansion's phases take. */
    public static int sampleCount(Expansion expansion) {
        return sampleCount(expansion, STEP);
    }

    /** Samples that serve where errors of 1e-6 of the largest coefficient are small beside the light: few fill a cache. */
    public static int fewSamples(Expansion expansion) {
        return sampleCount(expansion, COARSE_STEP);
    }

    private static int sampleCount(Expansion expansion, double step) {
        double steps = (expansion.maximumPhase() - expansion.minimumPhase()) / step;
        return (int) Math.min(MOST, Math.max(FEWEST, Math.ceil(steps)));
    }

    public int samples() {
        return values[0].length;
    }

    public int terms() {
        return values.length;
    }
}
