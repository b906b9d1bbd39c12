package sunbeam.precompute.expansion;

import java.util.Arrays;
import org.apache.commons.math3.linear.EigenDecomposition;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Quadrature rule over the heights of a patch: a weighted sum at a few heights replaces the mean over all samples. Each interval of bounded
 * phase has the Gauss rule of its heights with at most {@value #NODES} nodes, exact for polynomials up to degree 2 {@value #NODES} - 1.
 *
 * @param heights nodes of the rule: scaled heights, -1..1
 * @param shares weight of each node, as a share of the patch's samples
 */
record HeightRule(double[] heights, double[] shares) {
    // Difference over an interval of the phase zeta times scaled height at the largest zeta, radians. The squared error
    // of an expansion has bandwidth 1; its mean errs by at most 2 (INTERVAL / 4)^(2 NODES) / (2 NODES)! = 3e-24.
    private static final double INTERVAL = 4;
    private static final int NODES = 12;

    static HeightRule of(HeightLevels levels, HeightScale scale, double maximumPhase) {
        int count = Math.max(1, (int) Math.ceil(2 * maximumPhase / INTERVAL));
        Interval[] intervals = new Interval[count];
        boolean many = levels.areTooManyToTabulate();
        double[] all = many ? levels.map().heights() : levels.levels();
        int[] counts = many ? new int[0] : levels.histogram();
        for (int i = 0; i < all.length; i++) {
            double height = scale.scaled(all[i]);
            int at = Math.min(count - 1, Math.max(0, (int) ((height + 1) / 2 * count)));
            if (intervals[at] == null) {
                intervals[at] = new Interval();
            }
            intervals[at].add(height, many ? 1 : counts[i]);
        }
        double[] heights = new double[NODES * count];
        double[] shares = new double[NODES * count];
        int used = 0;
        for (Interval interval : intervals) {
            used = interval == null ? used : interval.addTo(heights, shares, used);
        }
        double samples = levels.map().heights().length;
        return new HeightRule(
                Arrays.copyOf(heights, used),
                Arrays.stream(shares, 0, used).map(share -> share / samples).toArray());
    }

    /**
     * Jacobi matrix of the heights in an interval, weighted by their numbers of samples; numerically stable rotations add a height (Gragg
     * and Harrod 1984).
     */
    private static final class Interval {
        private final double[] diagonal = new double[NODES];
        // Entry 0: total weight. Entry k: square of the matrix entry between rows k - 1 and k.
        private final double[] squares = new double[NODES];
        private int size;

        void add(double height, double weight) {
            if (size < NODES) {
                diagonal[size++] = height;
            }
            double cosine = 1;
            double sine = 0;
            double shift = 0;
            double rest = weight;
            for (int k = 0; k < size; k++) {
                double sum = squares[k] + rest;
                double square = squares[k];
                double sineBefore = sine;
                squares[k] = cosine * sum;
                cosine = sum > 0 ? square / sum : 1;
                sine = sum > 0 ? rest / sum : 0;
                double next = sine * (diagonal[k] - height) - cosine * shift;
                diagonal[k] -= next - shift;
                shift = next;
                rest = sine > 0 ? shift * shift / sine : sineBefore * square;
            }
        }

        /** Appends nodes and weights from index {@code used} on; returns the index after the last. */
        int addTo(double[] heights, double[] weights, int used) {
            double[] beside = new double[size - 1];
            for (int k = 1; k < size; k++) {
                beside[k - 1] = Math.sqrt(squares[k]);
            }
            EigenDecomposition matrix = new EigenDecomposition(Arrays.copyOf(diagonal, size), beside);
            int end = used;
            for (int n = 0; n < size; n++) {
                double first = matrix.getV().getEntry(0, n);
                if (first != 0) {
                    heights[end] = matrix.getRealEigenvalue(n);
                    weights[end++] = squares[0] * first * first;
                }
            }
            return end;
        }
    }
}
