package sunbeam.precompute.resample;

import sunbeam.precompute.expansion.PhaseNodes;

/** Means over the octave of phases around each node: the visible band is one for a direction. */
final class PhaseOctaves {
    private final PhaseNodes nodes;
    // Of each node: the first of its octave, and the first behind it.
    private final int[] first;
    private final int[] end;

    PhaseOctaves(PhaseNodes nodes) {
        this.nodes = nodes;
        first = new int[nodes.count()];
        end = new int[nodes.count()];
        for (int q = 0, low = 0, high = 0; q < first.length; q++) {
            while (nodes.node(low) * Math.sqrt(2) < nodes.node(q)) {
                low++;
            }
            while (high < first.length && nodes.node(high) <= nodes.node(q) * Math.sqrt(2)) {
                high++;
            }
            first[q] = low;
            end[q] = high;
        }
    }

    /** The means of values at the nodes. */
    double[] means(double[] values) {
        double[] sums = new double[values.length + 1];
        double[] weights = new double[values.length + 1];
        for (int q = 0; q < values.length; q++) {
            sums[q + 1] = sums[q] + nodes.weight(q) * values[q];
            weights[q + 1] = weights[q] + nodes.weight(q);
        }
        double[] means = new double[values.length];
        for (int q = 0; q < means.length; q++) {
            means[q] = (sums[end[q]] - sums[first[q]]) / (weights[end[q]] - weights[first[q]]);
        }
        return means;
    }
}
