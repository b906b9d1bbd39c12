package sunbeam.precompute.spectrum;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Functions of the phase zeta, {@code [sample][function]}, such as the coefficients c_n of an {@link Expansion}, at equal steps in radians.
 * Shaders interpolate them by parabolas through the nearest three samples.
 */
public record CoefficientTable(double minimumPhase, double maximumPhase, double[][] values) {
    // Error of the parabolas for functions of bandwidth and magnitude 1, per radian of phases: a third of float32's
    // rounding, since weak orders are small differences of large terms.
    private static final double LARGEST_ERROR = 2e-8;
    // The parabola through three samples errs by step^3 / PARABOLA.
    private static final double PARABOLA = 16;
    private static final int FEWEST_SAMPLES = 64;
    private static final int POINTS = 6;
    private static final int BEFORE = POINTS / 2 - 1;

    public static CoefficientTable sampled(Expansion expansion) {
        return sampled(expansion.minimumPhase(), expansion.maximumPhase(), 1, expansion::coefficients);
    }

    /** Returns samples between two phases of functions up to a bandwidth, radians per radian of phase. */
    public static CoefficientTable sampled(
            double low, double high, double bandwidth, DoubleFunction<double[]> functions) {
        int samples = sampleCount(high - low, bandwidth);
        double[][] values = IntStream.range(0, samples)
                .parallel()
                .mapToObj(i -> functions.apply(low + (high - low) * i / (samples - 1)))
                .toArray(double[][]::new);
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
        return values.length;
    }

    public int terms() {
        return values[0].length;
    }

    public float[] floats(int term) {
        return Floats.of(samples(), i -> values[i][term]);
    }

    /** Returns all functions at a phase, by polynomials of degree 5 with an error below 1e-9 of magnitude 1; clamped at the ends. */
    public double[] at(double phase) {
        double perSample = (maximumPhase - minimumPhase) / (samples() - 1);
        double place = Math.max(0, Math.min(samples() - 1.0, (phase - minimumPhase) / perSample));
        int first = Math.max(0, Math.min((int) place - BEFORE, samples() - POINTS));
        double[] sums = new double[terms()];
        for (int k = 0; k < POINTS; k++) {
            double weight = Lagrange.weight(place - first, k, POINTS);
            double[] sample = values[first + k];
            for (int n = 0; n < sums.length; n++) {
                sums[n] += weight * sample[n];
            }
        }
        return sums;
    }
}
