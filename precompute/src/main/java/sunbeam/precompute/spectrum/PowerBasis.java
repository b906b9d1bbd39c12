package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.util.KthSelector;
import org.apache.commons.math3.util.MathArrays;

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
    private final double[] weights;
    private final double[][] functions;
    /** Values of the functions' coefficients, {@code [function][bin]}. */
    final double[][] projections;

    PowerBasis(FourierTable table, double tolerance) {
        Expansion expansion = table.expansion();
        nodes = PhaseNodes.of(expansion.minimumPhase(), expansion.maximumPhase(), PowerSpectrum.BANDWIDTH);
        BinPowers powers = new BinPowers(table, nodes);
        double[][] rows =
                Arrays.stream(sample(powers, table.bins())).mapToObj(powers::at).toArray(double[][]::new);
        double[] mirror = mirror(table, powers);
        double[] typical = typical(rows, mirror);
        weights = new double[nodes.count()];
        Arrays.setAll(weights, q -> nodes.weights()[q] / (typical[q] * typical[q]));
        functions = basis(rows, mirror, tolerance);
        projections = powers.sums(Arrays.stream(functions)
                .map(function -> MathArrays.ebeMultiply(weights, function))
                .toArray(double[][]::new));
    }

    /** Powers of bin (0, 0), the only bin of a mirror; zeros if the table lacks the bin. */
    private double[] mirror(FourierTable table, BinPowers powers) {
        Band x = table.bandX();
        Band y = table.bandY();
        return x.holds(0) && y.holds(0) ? powers.at(-y.first() * x.count() - x.first()) : new double[nodes.count()];
    }

    /** Mean power in the octave around each phase, over all rows but the mirror's, each scaled by its own mean. */
    private double[] typical(double[][] rows, double[] mirror) {
        double[] sums = new double[nodes.count()];
        for (double[] row : rows) {
            if (!Arrays.equals(row, mirror)) {
                double mean = mean(row) + DARKEST;
                double[] around = octaveMeans(row);
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
        return BinPowers.sum(nodes.weights(), row);
    }

    private double[][] basis(double[][] rows, double[] mirror, double tolerance) {
        double[] first = mirror.clone();
        double length = Math.sqrt(product(mirror, mirror));
        Arrays.setAll(first, q -> length > 0 ? mirror[q] / length : 0);
        double[][] left = new double[rows.length][nodes.count()];
        for (int i = 0; i < rows.length; i++) {
            double share = product(rows[i], first);
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
                .map(i -> functionsNeeded(rows[i], all, tolerance))
                .toArray();
        return Arrays.copyOf(all, basisSize(functionsNeeded, rows));
    }

    private double product(double[] a, double[] b) {
        double sum = 0;
        for (int q = 0; q < weights.length; q++) {
            sum += weights[q] * a[q] * b[q];
        }
        return sum;
    }

    /** Fewest functions that approximate a row within the tolerance in every octave. */
    private int functionsNeeded(double[] row, double[][] all, double tolerance) {
        double[] allowed = octaveMeans(MathArrays.ebeMultiply(row, row));
        Arrays.setAll(allowed, q -> tolerance * tolerance * allowed[q] + DARKEST * DARKEST);
        double[] rest = row.clone();
        for (int n = 0; n < all.length; n++) {
            double share = product(row, all[n]);
            for (int q = 0; q < rest.length; q++) {
                rest[q] -= share * all[n][q];
            }
            double[] left = octaveMeans(MathArrays.ebeMultiply(rest, rest));
            if (IntStream.range(0, rest.length).allMatch(q -> left[q] <= allowed[q])) {
                return n + 1;
            }
        }
        return all.length;
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
                nodes.minimum(), nodes.maximum(), PowerSpectrum.BANDWIDTH, zeta -> nodes.interpolate(functions, zeta));
    }

    /** Means of a function's values at the nodes over the octave around each of them. */
    private double[] octaveMeans(double[] values) {
        double[] sums = new double[values.length + 1];
        double[] lengths = new double[values.length + 1];
        for (int q = 0; q < values.length; q++) {
            sums[q + 1] = sums[q] + nodes.weights()[q] * values[q];
            lengths[q + 1] = lengths[q] + nodes.weights()[q];
        }
        double[] phases = nodes.phases();
        double[] means = new double[values.length];
        for (int q = 0, first = 0, end = 0; q < values.length; q++) {
            while (phases[first] * Math.sqrt(2) < phases[q]) {
                first++;
            }
            while (end < values.length && phases[end] <= phases[q] * Math.sqrt(2)) {
                end++;
            }
            means[q] = (sums[end] - sums[first]) / (lengths[end] - lengths[first]);
        }
        return means;
    }

    /** Powers |F_j|^2 of single DFT bins at nodes of the phase zeta. */
    private static final class BinPowers {
        private final FourierTable table;
        private final Complex[] turns;
        // [node][term]
        private final double[][] coefficients;

        BinPowers(FourierTable table, PhaseNodes nodes) {
            this.table = table;
            turns = new Complex[table.terms()];
            Arrays.setAll(turns, table.expansion().kind()::turn);
            coefficients = new double[nodes.count()][];
            Arrays.setAll(coefficients, q -> table.expansion().coefficients(nodes.phases()[q]));
        }

        /** Returns real and imaginary parts of a bin's terms, each times its factor {@link Expansion.Kind#turn}. */
        private double[] terms(int bin) {
            double[] terms = new double[2 * turns.length];
            for (int n = 0; n < turns.length; n++) {
                double real = table.real()[n][bin];
                double imaginary = table.imaginary()[n][bin];
                terms[2 * n] = real * turns[n].getReal() - imaginary * turns[n].getImaginary();
                terms[2 * n + 1] = real * turns[n].getImaginary() + imaginary * turns[n].getReal();
            }
            return terms;
        }

        double[] at(int bin) {
            return powers(terms(bin));
        }

        private double[] powers(double[] terms) {
            double[] powers = new double[coefficients.length];
            Arrays.setAll(powers, q -> power(terms, coefficients[q]));
            return powers;
        }

        /** Returns the mean power of a bin at three nodes, so that a zero at one of them does not hide it. */
        double strength(int bin) {
            int nodes = coefficients.length;
            double[] terms = terms(bin);
            return (power(terms, coefficients[nodes / 6])
                            + power(terms, coefficients[nodes / 2])
                            + power(terms, coefficients[5 * nodes / 6]))
                    / 3;
        }

        /** Returns the inner products {@code [function][bin]} of all bins' powers with functions {@code [function][node]}. */
        double[][] sums(double[][] functions) {
            double[][] sums = new double[functions.length][table.bins()];
            int pairs = turns.length * (turns.length + 1) / 2;
            boolean fewTerms =
                    pairs * (2 + functions.length) < coefficients.length * (2 * turns.length + functions.length);
            double[][] weights = fewTerms ? pairWeights(functions, pairs) : functions;
            IntStream.range(0, table.bins()).parallel().forEach(bin -> {
                double[] terms = terms(bin);
                double[] inputs = fewTerms ? products(terms, pairs) : powers(terms);
                for (int n = 0; n < weights.length; n++) {
                    sums[n][bin] = sum(weights[n], inputs);
                }
            });
            return sums;
        }

        /** |sum_a c_a F_a|^2 = sum_ab c_a c_b Re(F_a F_b*), c real: returns the functions' products with c_a c_b, twice those for a != b. */
        private double[][] pairWeights(double[][] functions, int pairs) {
            double[][] weights = new double[functions.length][pairs];
            for (int n = 0; n < functions.length; n++) {
                for (int q = 0; q < coefficients.length; q++) {
                    int pair = 0;
                    for (int a = 0; a < turns.length; a++) {
                        for (int b = a; b < turns.length; b++) {
                            double twice = a == b ? 1 : 2;
                            weights[n][pair++] += twice * functions[n][q] * coefficients[q][a] * coefficients[q][b];
                        }
                    }
                }
            }
            return weights;
        }

        private static double[] products(double[] terms, int pairs) {
            double[] products = new double[pairs];
            int pair = 0;
            for (int a = 0; a < terms.length; a += 2) {
                double real = terms[a];
                double imaginary = terms[a + 1];
                for (int b = a; b < terms.length; b += 2) {
                    products[pair++] = real * terms[b] + imaginary * terms[b + 1];
                }
            }
            return products;
        }

        private static double sum(double[] weights, double[] values) {
            double sum = 0;
            for (int i = 0; i < values.length; i++) {
                sum += weights[i] * values[i];
            }
            return sum;
        }

        private static double power(double[] terms, double[] factors) {
            double real = 0;
            double imaginary = 0;
            for (int n = 0; n < factors.length; n++) {
                real += factors[n] * terms[2 * n];
                imaginary += factors[n] * terms[2 * n + 1];
            }
            return real * real + imaginary * imaginary;
        }
    }
}
