package sunbeam.precompute.expansion;

import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import sunbeam.precompute.numerics.Lagrange;

/**
 * Functions of the phase sampled at equal steps and interpolated by polynomials of degree 5. The power |F_j|^2 of a bin varies with the
 * phase zeta no faster than cos(2 zeta), for which the error is 5e-3 (2 step)^6 = 2e-10.
 *
 * @param minimum phase of the first sample, radians
 * @param values {@code [sample][function]}
 */
public record PhaseSamples(double minimum, double step, double[][] values) {
    private static final double WIDEST_STEP = 0.03;
    // Light that all grazes the surface has one phase only.
    private static final double SMALLEST_RANGE = 1e-3;
    private static final int POINTS = 6;
    private static final int BEFORE = POINTS / 2 - 1;

    /** Samples functions over a range of phases; interpolation beyond it returns the values at its ends. */
    public static PhaseSamples of(DoubleFunction<double[]> functions, double minimum, double maximum) {
        double range = Math.max(SMALLEST_RANGE, maximum - minimum);
        int steps = Math.max(POINTS, (int) Math.ceil(range / WIDEST_STEP));
        double step = range / steps;
        double[][] values = IntStream.rangeClosed(0, steps)
                .parallel()
                .mapToObj(i -> functions.apply(minimum + i * step))
                .toArray(double[][]::new);
        return new PhaseSamples(minimum, step, values);
    }

    /** Returns all functions at a phase in radians. */
    public double[] at(double phase) {
        double place = Math.max(0, Math.min(values.length - 1.0, (phase - minimum) / step));
        int first = Math.max(0, Math.min((int) place - BEFORE, values.length - POINTS));
        double[] sums = new double[values[0].length];
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
