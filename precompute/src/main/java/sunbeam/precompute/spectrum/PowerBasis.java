package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.util.KthSelector;

/**
 * Powers |F_j|^2 of the bins as functions of the phase, in the shortest real basis: the singular vectors of the powers of the strongest
 * bins and of a random sample. Each bin is scaled by its own mean, so that weak bins count as much as strong ones, and each phase by the
 * mean power in the octave around it, over which one color integrates, so that grazing light counts, too.
 */
final class PowerBasis {
    private static final int STRONGEST_BINS = 300;
    private static final int RANDOM_BINS = 300;
    // Bins of this share of the strongest one's strength (a mirror's among grains) must keep the tolerance.
    private static final double BRILLIANT = 0.01;
    // The promised accuracy begins at 1e-9.
    private static final double DARKEST = 1e-10;
    private static final long SEED = 20140507;

    private final PhaseNodes nodes;
    private final double[][] functions;
    private final double[][] projections;

    PowerBasis(FourierTable table, double tolerance) {
        Expansion expansion = table.expansion();
        nodes = PhaseNodes.of(expansion.minimumPhase(), expansion.maximumPhase(), PowerSpectrum.BANDWIDTH);
        PhaseOctaves octaves = PhaseOctaves.of(nodes);
        BinPowers powers = new BinPowers(table, nodes);
        double[][] rows =
                Arrays.stream(sample(powers, table.bins())).mapToObj(powers::at).toArray(double[][]::new);
        double[] mirror = mirror(table, powers);
        double[] typical = typical(rows, octaves, mirror);
        double[] weights = new double[nodes.count()];
        Arrays.setAll(weights, q -> nodes.weight(q) / (typical[q] * typical[q]));
        functions = basis(rows, mirror, weights, octaves, tolerance);
        double[][] weighted = new double[functions.length][nodes.count()];
        for (int n = 0; n < weighted.length; n++) {
            for (int q = 0; q < nodes.count(); q++) {
                weighted[n][q] = weights[q] * functions[n][q];
            }
        }
        projections = powers.sums(weighted);
    }

    /** Powers of bin (0, 0), the only bin of a mirror; zeros if the table lacks the bin. */
    private double[] mirror(FourierTable table, BinPowers powers) {
        Band x = table.bandX();
        Band y = table.bandY();
        return x.holds(0) && y.holds(0) ? powers.at(-y.first() * x.count() - x.first()) : new double[nodes.count()];
    }

    /** Mean power in the octave around each phase, over all rows but the mirror's, each scaled by its own mean. */
    private double[] typical(double[][] rows, PhaseOctaves octaves, double[] mirror) {
        double[] sums = new double[nodes.count()];
        for (double[] row : rows) {
            if (!Arrays.equals(row, mirror)) {
                double mean = mean(row) + DARKEST;
                double[] around = octaves.means(row);
                for (int q = 0; q < sums.length; q++) {
                    sums[q] += (around[q] + DARKEST) / mean / rows.length;
                }
            }
        }
        // The sums are 0 if all rows are the mirror's.
        Arrays.setAll(sums, q -> sums[q] == 0 ? 1 : sums[q]);
        return sums;
    }

    private double mean(double[] row) {
        double mean = 0;
        for (int q = 0; q < row.length; q++) {
            mean += nodes.weight(q) * row[q];
        }
        return mean;
    }

    private double[][] basis(
            double[][] rows, double[] mirror, double[] weights, PhaseOctaves octaves, double tolerance) {
        double[] first = mirror.clone();
        double length = Math.sqrt(product(mirror, mirror, weights));
        Arrays.setAll(first, q -> length > 0 ? mirror[q] / length : 0);
        double[][] left = new double[rows.length][nodes.count()];
        for (int i = 0; i < rows.length; i++) {
            double share = product(rows[i], first, weights);
            double mean = mean(rows[i]) + DARKEST;
            for (int q = 0; q < weights.length; q++) {
                left[i][q] = (rows[i][q] - share * first[q]) / mean * Math.sqrt(weights[q]);
            }
        }
        // If the matrix has fewer rows than columns, the library transposes it and exchanges U and V.
        SingularValueDecomposition decomposition =
                new SingularValueDecomposition(new Array2DRowRealMatrix(left, false));
        int most = decomposition.getSingularValues().length;
        double[][] all = new double[most + 1][nodes.count()];
        all[0] = first;
        for (int n = 0; n < most; n++) {
            for (int q = 0; q < weights.length; q++) {
                all[n + 1][q] = decomposition.getV().getEntry(q, n) / Math.sqrt(weights[q]);
            }
        }
        int[] functionsNeeded = IntStream.range(0, rows.length)
                .parallel()
                .map(i -> functionsNeeded(rows[i], all, weights, octaves, tolerance))
                .toArray();
        return Arrays.copyOf(all, basisSize(functionsNeeded, rows));
    }

    private static double product(double[] a, double[] b, double[] weights) {
        double sum = 0;
        for (int q = 0; q < weights.length; q++) {
            sum += weights[q] * a[q] * b[q];
        }
        return sum;
    }

    /** Fewest functions that approximate a row within the tolerance in every octave. */
    private static int functionsNeeded(
            double[] row, double[][] all, double[] weights, PhaseOctaves octaves, double tolerance) {
        double[] allowed = octaves.means(squares(row));
        Arrays.setAll(allowed, q -> tolerance * tolerance * allowed[q] + DARKEST * DARKEST);
        double[] rest = row.clone();
        for (int n = 0; n < all.length; n++) {
            double share = product(row, all[n], weights);
            for (int q = 0; q < rest.length; q++) {
                rest[q] -= share * all[n][q];
            }
            double[] left = octaves.means(squares(rest));
            if (IntStream.range(0, rest.length).allMatch(q -> left[q] <= allowed[q])) {
                return n + 1;
            }
        }
        return all.length;
    }

    private static double[] squares(double[] values) {
        return Arrays.stream(values).map(value -> value * value).toArray();
    }

    /** Functions that suffice for all brilliant rows and 99 of 100 others: a limit of the mean error would drop a grating's weak orders. */
    private int basisSize(int[] functionsNeeded, double[][] rows) {
        int[] sorted = Arrays.stream(functionsNeeded).sorted().toArray();
        int most = sorted[sorted.length - 1 - sorted.length / 100];
        double strongest = Arrays.stream(rows).mapToDouble(this::mean).max().orElse(0);
        for (int i = 0; i < rows.length; i++) {
            most = mean(rows[i]) >= BRILLIANT * strongest ? Math.max(most, functionsNeeded[i]) : most;
        }
        return most;
    }

    /** Returns the strongest bins, whose tails outshine their surroundings, and a random sample. */
    private static int[] sample(BinPowers powers, int bins) {
        double[] strengths = new double[bins];
        Arrays.parallelSetAll(strengths, powers::strength);
        double strong = new KthSelector().select(strengths.clone(), null, Math.max(0, bins - STRONGEST_BINS));
        // Among equally strong bins, as a grating has, the first ones.
        long stronger = Arrays.stream(strengths).filter(s -> s > strong).count();
        IntStream strongest = IntStream.concat(
                IntStream.range(0, bins).filter(bin -> strengths[bin] > strong),
                IntStream.range(0, bins)
                        .filter(bin -> strengths[bin] == strong && strong > 0)
                        .limit(STRONGEST_BINS - stronger));
        IntStream random = new SplittableRandom(SEED).ints(Math.min(RANDOM_BINS, bins), 0, bins);
        return IntStream.concat(strongest, random).toArray();
    }

    CoefficientTable coefficients() {
        return CoefficientTable.sampled(
                nodes.minimum(),
                nodes.maximum(),
                PowerSpectrum.BANDWIDTH,
                zeta -> nodes.interpolate(functions, functions.length, zeta));
    }

    double[][] projections() {
        return projections;
    }

    /** Octave around each node: its first node, and the node after its last. */
    private record PhaseOctaves(PhaseNodes nodes, int[] first, int[] end) {
        static PhaseOctaves of(PhaseNodes nodes) {
            PhaseOctaves octaves = new PhaseOctaves(nodes, new int[nodes.count()], new int[nodes.count()]);
            for (int q = 0, low = 0, high = 0; q < nodes.count(); q++) {
                while (nodes.node(low) * Math.sqrt(2) < nodes.node(q)) {
                    low++;
                }
                while (high < nodes.count() && nodes.node(high) <= nodes.node(q) * Math.sqrt(2)) {
                    high++;
                }
                octaves.first[q] = low;
                octaves.end[q] = high;
            }
            return octaves;
        }

        double[] means(double[] values) {
            double[] sums = new double[values.length + 1];
            double[] weights = new double[values.length + 1];
            for (int q = 0; q < values.length; q++) {
                sums[q + 1] = sums[q] + nodes.weight(q) * values[q];
                weights[q + 1] = weights[q] + nodes.weight(q);
            }
            double[] means = new double[values.length];
            Arrays.setAll(means, q -> (sums[end[q]] - sums[first[q]]) / (weights[end[q]] - weights[first[q]]));
            return means;
        }
    }
}
