package sunbeam.precompute.expansion;

import java.util.Arrays;
import sunbeam.precompute.numerics.GaussLegendre;

/**
 * Gauss-Legendre nodes over a range of phases. Functions of little bandwidth are integrated and, between nodes,
 * barycentrically interpolated without error.
 */
public final class PhaseNodes {
    // Functions of bandwidth 1 need one node per pi of phase; the rest is for the digits.
    private static final int EXTRA_NODES = 28;
    // A range of phases of no width (one direction, one wavelength) is widened by this.
    private static final double SMALLEST_RANGE = 1e-3;

    private final double minimum;
    private final double maximum;
    private final double[] nodes;
    private final double[] weights;
    private final double[] barycentric;

    /**
     * Places the nodes.
     *
     * @param bandwidth largest frequency, in radians per radian of phase, of the functions that are meant
     */
    public PhaseNodes(double minimum, double maximum, double bandwidth) {
        this.minimum = minimum;
        this.maximum = Math.max(maximum, minimum + SMALLEST_RANGE);
        int count = EXTRA_NODES + (int) Math.ceil(bandwidth * (this.maximum - minimum));
        nodes = new double[count];
        weights = new double[count];
        barycentric = new double[count];
        GaussLegendre rule = GaussLegendre.of(count);
        for (int q = 0; q < count; q++) {
            double x = rule.nodes()[q];
            nodes[q] = minimum + (x + 1) / 2 * (this.maximum - minimum);
            weights[q] = rule.weights()[q] / 2;
            // Berrut and Trefethen 2004, section 5, for Legendre points.
            barycentric[q] = (q % 2 == 0 ? 1 : -1) * Math.sqrt((1 - x * x) * rule.weights()[q]);
        }
    }

    public int count() {
        return nodes.length;
    }

    public double minimum() {
        return minimum;
    }

    public double maximum() {
        return maximum;
    }

    public double node(int index) {
        return nodes[index];
    }

    /** Weight of a node in the mean over the phases; all weights together are 1. */
    public double weight(int index) {
        return weights[index];
    }

    /**
     * Functions between the nodes.
     *
     * @param functions values at the nodes, {@code [function][node]}
     * @param count how many of the functions are wanted, from the first
     */
    public double[] interpolate(double[][] functions, int count, double zeta) {
        double[] sums = new double[count];
        double denominator = 0;
        for (int q = 0; q < nodes.length; q++) {
            double difference = zeta - nodes[q];
            if (difference == 0) {
                int node = q;
                Arrays.setAll(sums, n -> functions[n][node]);
                return sums;
            }
            double weight = barycentric[q] / difference;
            for (int n = 0; n < count; n++) {
                sums[n] += weight * functions[n][q];
            }
            denominator += weight;
        }
        for (int n = 0; n < count; n++) {
            sums[n] /= denominator;
        }
        return sums;
    }
}
