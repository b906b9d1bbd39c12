package sunbeam.precompute.spectrum;

import java.util.Arrays;

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

    /** Gauss-Legendre rule over -1..1: ascending nodes, and weights with the sum 2. Newton's method finds Legendre's zeros. */
    public record GaussLegendre(double[] nodes, double[] weights) {
        // Four digits at the start, doubled by each iteration; zeros near the ends start worse.
        private static final int ITERATIONS = 6;

        public static GaussLegendre of(int count) {
            double[] nodes = new double[count];
            double[] weights = new double[count];
            for (int i = 0; i < count; i++) {
                double x = -Math.cos(Math.PI * (i + 0.75) / (count + 0.5));
                double derivative = 0;
                for (int iteration = 0; iteration < ITERATIONS; iteration++) {
                    double value = 1;
                    double before = 0;
                    for (int n = 1; n <= count; n++) {
                        double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
                        before = value;
                        value = next;
                    }
                    derivative = count * (before - x * value) / ((1 - x) * (1 + x));
                    x -= value / derivative;
                }
                nodes[i] = x;
                weights[i] = 2 / ((1 - x) * (1 + x) * derivative * derivative);
            }
            return new GaussLegendre(nodes, weights);
        }
    }
}
