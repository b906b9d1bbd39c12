package sunbeam.precompute.expansion;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * Coefficients c_n(zeta) sampled at equal steps of the phase, real; between samples, parabolas through the nearest three.
 *
 * @param minimumPhase zeta of the first sample
 * @param maximumPhase zeta of the last sample
 * @param values {@code [term][sample]}
 */
public record CoefficientTable(double minimumPhase, double maximumPhase, float[][] values) {

    // Error of a parabola, of functions of bandwidth 1 and size 1: by radian of the largest phase, a third of what
    // float32 rounds of that phase; at least a third of what it rounds of the coefficients themselves. Weak orders are
    // small differences of large terms, and see both.
    private static final double ERROR = 2e-8;
    // The parabola through three samples errs by the step's third power over this.
    private static final double PARABOLA = 16;
    private static final int FEWEST = 64;

    /** Samples all coefficients of an expansion over its phases. */
    public static CoefficientTable sampled(Expansion expansion) {
        return sampled(
                expansion.minimumPhase(), expansion.maximumPhase(), 1, expansion.terms(), expansion::coefficients);
    }

    /**
     * Samples functions of the phase.
     *
     * @param bandwidth their largest frequency, in radians per radian of phase
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

    /**
     * Samples that functions of some bandwidth take over the phases of an expansion, for layouts of their textures.
     *
     * @param bandwidth as for {@link #sampled(double, double, double, int, DoubleFunction)}
     */
    public static int sampleCount(Expansion expansion, double bandwidth) {
        return sampleCount(expansion.maximumPhase() - expansion.minimumPhase(), bandwidth);
    }

    private static int sampleCount(double range, double bandwidth) {
        double step = Math.cbrt(PARABOLA * ERROR * Math.max(1, range)) / bandwidth;
        return (int) Math.max(FEWEST, Math.ceil(range / step) + 1);
    }

    public int samples() {
        return values[0].length;
    }

    public int terms() {
        return values.length;
    }
}
