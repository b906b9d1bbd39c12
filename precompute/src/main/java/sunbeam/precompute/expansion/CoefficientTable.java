package sunbeam.precompute.expansion;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * Coefficients c_n(zeta) sampled at equal steps of the phase, real; between samples, cubics through four of them.
 *
 * @param minimumPhase zeta of the first sample
 * @param maximumPhase zeta of the last sample
 * @param values {@code [term][sample]}
 */
public record CoefficientTable(double minimumPhase, double maximumPhase, float[][] values) {

    // Radians for functions of bandwidth 1, as the coefficients are. The cubic through four samples errs by 3 / 128 of
    // the
    // step's fourth power: 2e-8, less than float32 rounds. Weak orders are small differences of large terms, and see
    // the
    // error of these.
    private static final double STEP = 0.03;
    private static final int FEWEST = 64;
    // Texels along a row that every driver of OpenGL 3.3 has.
    private static final int LONGEST_ROW = 16384;
    /** Samples at the start of a row that repeat the end of the row before: a cubic goes through four side by side. */
    public static final int REPEATED = 3;

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
        int needed = (int) Math.max(FEWEST, Math.ceil(bandwidth * range / STEP) + 1);
        int pieces = pieces(needed);
        // As many in each piece.
        return (needed - REPEATED + pieces - 1) / pieces * pieces + REPEATED;
    }

    /** Rows of texels that so many samples of a function take. */
    public static int pieces(int samples) {
        return (samples - REPEATED + LONGEST_ROW - REPEATED - 1) / (LONGEST_ROW - REPEATED);
    }

    public int samples() {
        return values[0].length;
    }

    public int terms() {
        return values.length;
    }
}
