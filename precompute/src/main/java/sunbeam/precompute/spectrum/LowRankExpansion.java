package sunbeam.precompute.spectrum;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.special.BesselJ;
import sunbeam.precompute.optics.HeightMap;

/**
 * Expansion with the fewest terms for one patch: singular vectors of the kernel exp(-i zeta s), sampled at Gauss-Legendre nodes of the phases
 * that a scene needs and at the heights of a {@link HeightRule}, weighted by their number of samples (Eckart and Young 1936). The c_n are
 * real and orthonormal over the phases, {@code functions[n][node]}; T_n, the mean over zeta of c_n(zeta) exp(-i zeta s), is the Chebyshev
 * series {@code series[n]}.
 */
public record LowRankExpansion(
        HeightScale scale, PhaseNodes nodes, int terms, double error, double[][] functions, double[][] series)
        implements Expansion {
    // Relative to the largest coefficient of all terms: a hundredth of a double's rounding.
    private static final double SMALLEST_SIGNIFICANT = 1e-18;

    /** Returns the fewest terms, at most {@code mostTerms}, whose rms error over heights and phases is within a tolerance. */
    public static LowRankExpansion of(
            HeightMap heights,
            HeightScale scale,
            double minimumPhase,
            double maximumPhase,
            double tolerance,
            int mostTerms) {
        // The bandwidth is 1, since |s| is at most 1.
        PhaseNodes nodes = PhaseNodes.of(minimumPhase, maximumPhase, 1);
        // A Gram matrix would lose half of the digits: where nearly no light is diffracted, errors of 1e-9 count. The
        // triangular QR factor has few rows and the same singular values and right vectors.
        RealMatrix triangle = new QRDecomposition(kernel(HeightRule.of(heights, scale, maximumPhase), nodes)).getR();
        int last = nodes.count() - 1;
        SingularValueDecomposition decomposition =
                new SingularValueDecomposition(triangle.getSubMatrix(0, last, 0, last));
        double[] errors = errors(decomposition.getSingularValues());
        int terms = 1;
        while (terms < Math.min(mostTerms, last + 1) && errors[terms] > tolerance) {
            terms++;
        }
        double[][] functions = new double[terms][nodes.count()];
        for (int n = 0; n < terms; n++) {
            for (int q = 0; q < nodes.count(); q++) {
                functions[n][q] = decomposition.getV().getEntry(q, n) / Math.sqrt(nodes.weights()[q]);
            }
        }
        double[][] series = chebyshevSeries(functions, nodes);
        int length = significantLength(series);
        return new LowRankExpansion(
                scale,
                nodes,
                terms,
                errors[terms],
                functions,
                Arrays.stream(series).map(one -> Arrays.copyOf(one, length)).toArray(double[][]::new));
    }

    /** Real and imaginary parts of exp(-i zeta s) are separate rows, so that the functions of the phase are real. */
    private static RealMatrix kernel(HeightRule rule, PhaseNodes nodes) {
        int heights = rule.heights().length;
        // A QR decomposition needs at least as many rows as columns.
        double[][] matrix = new double[Math.max(2 * heights, nodes.count())][nodes.count()];
        for (int i = 0; i < heights; i++) {
            for (int q = 0; q < nodes.count(); q++) {
                double factor = Math.sqrt(rule.shares()[i] * nodes.weights()[q]);
                double phase = nodes.phases()[q] * rule.heights()[i];
                matrix[2 * i][q] = factor * Math.cos(phase);
                matrix[2 * i + 1][q] = factor * Math.sin(phase);
            }
        }
        return new Array2DRowRealMatrix(matrix, false);
    }

    private static double[] errors(double[] singularValues) {
        double[] errors = new double[singularValues.length + 1];
        double tail = 0;
        for (int n = singularValues.length - 1; n >= 0; n--) {
            tail += singularValues[n] * singularValues[n];
            errors[n] = Math.sqrt(tail);
        }
        return errors;
    }

    /** {@code [n][k]} multiplies the Chebyshev polynomial of degree k; even k belong to the real part of T_n, odd k to the imaginary. */
    private static double[][] chebyshevSeries(double[][] functions, PhaseNodes nodes) {
        // Beyond n = zeta, J_n(zeta) falls faster than exponentially; 12 zeta^(1/3) orders later it is below 1e-17.
        int length = (int) Math.ceil(nodes.maximum() + 12 * Math.cbrt(nodes.maximum()) + 12);
        double[][] series = new double[functions.length][length];
        for (int q = 0; q < nodes.count(); q++) {
            double[] coefficients = bessel(length, nodes.phases()[q]);
            for (int k = 0; k < length; k++) {
                // (-i)^k is 1, -i, -1, i.
                double sign = k % 4 == 0 || k % 4 == 3 ? 1 : -1;
                double bessel = sign * nodes.weights()[q] * coefficients[k];
                for (int n = 0; n < functions.length; n++) {
                    series[n][k] += bessel * functions[n][q];
                }
            }
        }
        return series;
    }

    /** Returns J_0(zeta) and 2 J_n(zeta): exp(-i zeta s) in Chebyshev polynomials without factors (-i)^n (Jacobi-Anger, DLMF 10.12.3). */
    private static double[] bessel(int count, double zeta) {
        BesselJ.BesselJResult result = BesselJ.rjBesl(zeta, 0, count);
        double[] values = result.getVals();
        // The library does not compute orders that underflow a double.
        for (int n = 1; n < count; n++) {
            values[n] = n < result.getnVals() || result.getnVals() == count ? 2 * values[n] : 0;
        }
        return values;
    }

    private static int significantLength(double[][] series) {
        double largest = Arrays.stream(series)
                .flatMapToDouble(Arrays::stream)
                .map(Math::abs)
                .max()
                .orElseThrow();
        return 1
                + IntStream.range(2, series[0].length)
                        .filter(k -> Arrays.stream(series)
                                .anyMatch(one -> Math.abs(one[k]) > SMALLEST_SIGNIFICANT * largest))
                        .max()
                        .orElse(1);
    }

    @Override
    public Kind kind() {
        return Kind.LOWRANK;
    }

    /** Sums the even polynomials (Jacobi-Anger): with s = cos x, C_2j(s) = cos 2jx = C_j(y), y = 2 s^2 - 1. */
    @Override
    public double realBasis(int n, double s) {
        double y = 2 * s * s - 1;
        return clenshaw(series[n], 0, y, y);
    }

    /** Sums the odd Chebyshev polynomials: C_2j+1(s) = s V_j(y), V_j of the third kind (DLMF 18.5.3). */
    @Override
    public double imaginaryBasis(int n, double s) {
        double y = 2 * s * s - 1;
        return s * clenshaw(series[n], 1, y, 2 * y - 1);
    }

    /** Sums every second c_j p_j by Clenshaw's recurrence, with p_0 = 1, p_1 = {@code first} and p_j+1 = 2 y p_j - p_j-1. */
    private static double clenshaw(double[] coefficients, int parity, double y, double first) {
        double next = 0;
        double afterNext = 0;
        for (int k = (coefficients.length - 1 - parity) / 2 * 2 + parity; k > parity; k -= 2) {
            double value = 2 * y * next - afterNext + coefficients[k];
            afterNext = next;
            next = value;
        }
        return first * next - afterNext + coefficients[parity];
    }

    @Override
    public double[] coefficients(double zeta) {
        return nodes.interpolate(functions, zeta);
    }

    @Override
    public double minimumPhase() {
        return nodes.minimum();
    }

    @Override
    public double maximumPhase() {
        return nodes.maximum();
    }

    /**
     * Quadrature rule over the heights of a patch: a weighted sum at a few scaled heights, with shares of the samples as weights, replaces
     * the mean over all samples. Each interval of bounded phase has the Gauss rule of its heights with at most {@value #NODES} nodes, exact
     * for polynomials up to degree 2 {@value #NODES} - 1.
     */
    private record HeightRule(double[] heights, double[] shares) {
        // Difference of zeta times scaled height over an interval of heights, radians, at the largest phase zeta.
        // The squared error of an expansion has bandwidth 1.
        // Its mean errs by 2 (INTERVAL / 4)^(2 NODES) / (2 NODES)! = 3e-24.
        private static final double INTERVAL = 4;
        private static final int NODES = 12;

        static HeightRule of(HeightMap levels, HeightScale scale, double maximumPhase) {
            int count = Math.max(1, (int) Math.ceil(2 * maximumPhase / INTERVAL));
            Interval[] intervals = new Interval[count];
            Arrays.setAll(intervals, i -> new Interval());
            boolean many = levels.hasTooManyLevels();
            double[] all = many ? levels.heights() : levels.levels();
            int[] counts = many ? new int[0] : levels.histogram();
            for (int i = 0; i < all.length; i++) {
                double height = scale.scaled(all[i]);
                int at = Math.min(count - 1, Math.max(0, (int) ((height + 1) / 2 * count)));
                intervals[at].add(height, many ? 1 : counts[i]);
            }
            DoubleStream.Builder heights = DoubleStream.builder();
            DoubleStream.Builder shares = DoubleStream.builder();
            for (Interval interval : intervals) {
                interval.addTo(heights, shares, levels.heights().length);
            }
            return new HeightRule(heights.build().toArray(), shares.build().toArray());
        }

        /** Jacobi matrix of the heights in an interval, weighted by number; stable rotations add one (Gragg and Harrod 1984). */
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

            void addTo(DoubleStream.Builder heights, DoubleStream.Builder shares, double samples) {
                if (size == 0) {
                    return;
                }
                double[] beside =
                        Arrays.stream(squares, 1, size).map(Math::sqrt).toArray();
                EigenDecomposition matrix = new EigenDecomposition(Arrays.copyOf(diagonal, size), beside);
                for (int n = 0; n < size; n++) {
                    double first = matrix.getV().getEntry(0, n);
                    if (first != 0) {
                        heights.add(matrix.getRealEigenvalue(n));
                        shares.add(squares[0] * first * first / samples);
                    }
                }
            }
        }
    }
}
