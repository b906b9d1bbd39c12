package sunbeam.precompute.spectrum;

import java.util.Arrays;
import sunbeam.precompute.numerics.GaussLegendre;

/**
 * Gauss-Legendre nodes over a range of phases, in radians. They integrate functions of limited bandwidth (radians per radian of phase), and
 * interpolate them by the barycentric formula, to a double's rounding. Weights add up to 1.
 */
public record PhaseNodes(double minimum, double maximum, double[] phases, double[] weights, double[] barycentric) {
    // Beyond one node per radian of phase and bandwidth; for a double's rounding also over short ranges.
    private static final int EXTRA_NODES = 28;
    // Radians; a single direction at a single wavelength has a range of 0.
    private static final double SMALLEST_RANGE = 1e-3;

    public static PhaseNodes of(double minimum, double maximum, double bandwidth) {
        double end = Math.max(maximum, minimum + SMALLEST_RANGE);
        GaussLegendre rule = GaussLegendre.of(EXTRA_NODES + (int) Math.ceil(bandwidth * (end - minimum)));
        int count = rule.nodes().length;
        PhaseNodes all = new PhaseNodes(minimum, end, new double[count], new double[count], new double[count]);
        for (int q = 0; q < count; q++) {
            double x = rule.nodes()[q];
            all.phases[q] = minimum + (x + 1) / 2 * (end - minimum);
            all.weights[q] = rule.weights()[q] / 2;
            // Berrut and Trefethen 2004, section 5, for Legendre points.
            all.barycentric[q] = (q % 2 == 0 ? 1 : -1) * Math.sqrt((1 - x * x) * rule.weights()[q]);
        }
        return all;
    }

    public int count() {
        return phases.length;
    }

    /** Interpolates functions, {@code [function][node]}, at a phase. */
    public double[] interpolate(double[][] functions, double zeta) {
        double[] sums = new double[functions.length];
        double denominator = 0;
        for (int q = 0; q < phases.length; q++) {
            double difference = zeta - phases[q];
            if (difference == 0) {
                int node = q;
                Arrays.setAll(sums, n -> functions[n][node]);
                return sums;
            }
            double weight = barycentric[q] / difference;
            for (int n = 0; n < sums.length; n++) {
                sums[n] += weight * functions[n][q];
            }
            denominator += weight;
        }
        for (int n = 0; n < sums.length; n++) {
            sums[n] /= denominator;
        }
        return sums;
    }
}
