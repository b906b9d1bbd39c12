package sunbeam.precompute.resample;

import java.util.Arrays;
import java.util.PriorityQueue;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.Expansion;
import sunbeam.precompute.expansion.PhaseNodes;
import sunbeam.precompute.table.FourierTable;

/**
 * Powers |F_j|^2 of the bins as a function of the phase, in the shortest real basis: the singular vectors of the powers of
 * the strongest bins and of a sample of all, each relative to its own mean, so that weak bins count as much as strong ones.
 */
public final class PowerFields implements Fields {
    private static final int STRONGEST_BINS = 300;
    private static final int RANDOM_BINS = 300;
    // Bins this much of the strongest are seen alone, a mirror's among grains for instance: none of them may be missed.
    private static final double BRILLIANT = 0.01;
    // A bin this dark is not worth a function of its own: the promise begins at a power of 1e-9.
    private static final double DARKEST = 1e-10;
    // Of a row whose bin has no light, squared.
    private static final double SMALLEST_ROW = 1e-4;
    // The sample of bins is the same at every run.
    private static final long SEED = 20140507;

    private final PhaseNodes nodes;
    private final double[][] functions;
    private final double[][] fields;

    /**
     * Projects all bins on the basis.
     *
     * @param tolerance relative root-mean-square error of the powers over the phases
     */
    public PowerFields(FourierTable table, Expansion expansion, double tolerance) {
        // Two heights differ by at most 2 in s.
        nodes = new PhaseNodes(expansion.minimumPhase(), expansion.maximumPhase(), 2);
        BinPowers powers = new BinPowers(table, expansion, nodes);
        functions = basis(powers, tolerance);
        double[][] weighted = new double[functions.length][nodes.count()];
        for (int n = 0; n < weighted.length; n++) {
            for (int q = 0; q < nodes.count(); q++) {
                weighted[n][q] = nodes.weight(q) * functions[n][q];
            }
        }
        fields = powers.sums(weighted);
    }

    private double[][] basis(BinPowers powers, double tolerance) {
        int[] bins = sample(powers);
        double[][] rows = new double[bins.length][nodes.count()];
        for (int i = 0; i < bins.length; i++) {
            double[] row = rows[i];
            double[] power = powers.at(bins[i]);
            double mean = 0;
            for (int q = 0; q < power.length; q++) {
                mean += nodes.weight(q) * power[q];
            }
            for (int q = 0; q < power.length; q++) {
                row[q] = power[q] / (mean + DARKEST) * Math.sqrt(nodes.weight(q));
            }
        }
        // Columns of the right singular vectors; transposed so that the matrix has more rows than columns.
        SingularValueDecomposition decomposition =
                new SingularValueDecomposition(new Array2DRowRealMatrix(rows, false));
        double strongest =
                Arrays.stream(bins).mapToDouble(powers::strength).max().orElse(0);
        boolean[] brilliant = new boolean[bins.length];
        for (int i = 0; i < bins.length; i++) {
            brilliant[i] = powers.strength(bins[i]) >= BRILLIANT * strongest;
        }
        int rank = rank(decomposition, brilliant, tolerance);
        double[][] result = new double[rank][nodes.count()];
        for (int n = 0; n < rank; n++) {
            for (int q = 0; q < nodes.count(); q++) {
                result[n][q] = decomposition.getV().getEntry(q, n) / Math.sqrt(nodes.weight(q));
            }
        }
        return result;
    }

    /**
     * The fewest functions that leave of each row, but for one in a hundred that is not brilliant, no more than the
     * tolerance. A mean over all rows would let the few of a grating's weak orders go.
     */
    private static int rank(SingularValueDecomposition decomposition, boolean[] brilliant, double tolerance) {
        RealMatrix left = decomposition.getU();
        double[] values = decomposition.getSingularValues();
        int rows = left.getRowDimension();
        double[] rest = new double[rows];
        double[] norm = new double[rows];
        for (int row = 0; row < rows; row++) {
            for (int n = 0; n < values.length; n++) {
                norm[row] += Math.pow(left.getEntry(row, n) * values[n], 2);
            }
            rest[row] = norm[row];
        }
        for (int rank = 1; rank < values.length; rank++) {
            int missed = 0;
            for (int row = 0; row < rows; row++) {
                rest[row] -= Math.pow(left.getEntry(row, rank - 1) * values[rank - 1], 2);
                // What is left of a row that is represented is rounding, which may be negative.
                if (rest[row] > tolerance * tolerance * Math.max(norm[row], SMALLEST_ROW)) {
                    missed += brilliant[row] ? rows : 1;
                }
            }
            if (missed <= rows / 100) {
                return rank;
            }
        }
        return values.length;
    }

    /** The strongest bins, which outshine their surroundings through the window's tails, and some of all. */
    private static int[] sample(BinPowers powers) {
        double[] strengths = new double[powers.bins()];
        Arrays.parallelSetAll(strengths, powers::strength);
        double strong = largest(strengths, STRONGEST_BINS);
        // Of equally strong bins, as in the row of a grating, whichever come first; what is dark is not strong.
        long stronger = Arrays.stream(strengths).filter(s -> s > strong).count();
        IntStream strongest = IntStream.concat(
                IntStream.range(0, strengths.length).filter(bin -> strengths[bin] > strong),
                IntStream.range(0, strengths.length)
                        .filter(bin -> strengths[bin] == strong && strong > 0)
                        .limit(STRONGEST_BINS - stronger));
        IntStream random =
                new SplittableRandom(SEED).ints(Math.min(RANDOM_BINS, strengths.length), 0, strengths.length);
        return IntStream.concat(strongest, random).toArray();
    }

    /** The last of so many largest values, or of all where there are fewer. */
    private static double largest(double[] values, int count) {
        PriorityQueue<Double> largest = new PriorityQueue<>(count);
        for (double value : values) {
            if (largest.size() < count) {
                largest.add(value);
            } else if (value > largest.element()) {
                largest.remove();
                largest.add(value);
            }
        }
        return largest.element();
    }

    /** The basis at a phase. */
    public double[] functions(double zeta) {
        return nodes.interpolate(functions, functions.length, zeta);
    }

    /** Power of one bin, given the {@link #functions} of a phase. */
    public double power(double[] atPhase, int bin) {
        double power = 0;
        for (int n = 0; n < fields.length; n++) {
            power += atPhase[n] * fields[n][bin];
        }
        return power;
    }

    @Override
    public int count() {
        return fields.length;
    }

    @Override
    public double[] field(int index) {
        return fields[index];
    }

    @Override
    public CoefficientTable coefficients(int samples) {
        return CoefficientTable.sampled(nodes.minimum(), nodes.maximum(), functions.length, this::functions, samples);
    }
}
