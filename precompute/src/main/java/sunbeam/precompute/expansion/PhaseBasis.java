package sunbeam.precompute.expansion;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.special.BesselJ;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Orthonormal functions of the phase, best first, for the kernel exp(-i zeta s) weighted by the heights that occur: the
 * right singular vectors of its matrix, discretised at Gauss-Legendre nodes.
 */
final class PhaseBasis {
    private final PhaseNodes nodes;
    private final double[][] functions;
    private final double[] squares;

    private PhaseBasis(PhaseNodes nodes, HeightRule rule) {
        this.nodes = nodes;
        // Of the kernel itself, not of its Gram matrix, whose squares are the squares and lose half of the digits:
        // where nearly no light is diffracted, errors of 1e-9 count.
        // Its triangular factor, of few rows, has the same.
        RealMatrix triangle = new QRDecomposition(kernel(rule)).getR();
        int last = nodes.count() - 1;
        SingularValueDecomposition decomposition =
                new SingularValueDecomposition(triangle.getSubMatrix(0, last, 0, last));
        squares = decomposition.getSingularValues();
        functions = new double[squares.length][nodes.count()];
        for (int n = 0; n < functions.length; n++) {
            squares[n] *= squares[n];
            for (int q = 0; q < nodes.count(); q++) {
                functions[n][q] = decomposition.getV().getEntry(q, n) / Math.sqrt(nodes.weight(q));
            }
        }
    }

    static PhaseBasis of(HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase) {
        // |s| is at most 1.
        return new PhaseBasis(
                new PhaseNodes(minimumPhase, maximumPhase, 1), HeightRule.of(heights, scale, maximumPhase));
    }

    /** Real and imaginary parts of exp(-i zeta s) are rows of their own: real functions of the phase serve both. */
    private RealMatrix kernel(HeightRule rule) {
        int heights = rule.heights().length;
        // At least as many rows as columns.
        double[][] matrix = new double[Math.max(2 * heights, nodes.count())][nodes.count()];
        for (int i = 0; i < heights; i++) {
            for (int q = 0; q < nodes.count(); q++) {
                double factor = Math.sqrt(rule.shares()[i] * nodes.weight(q));
                double phase = nodes.node(q) * rule.heights()[i];
                matrix[2 * i][q] = factor * Math.cos(phase);
                matrix[2 * i + 1][q] = factor * Math.sin(phase);
            }
        }
        return new Array2DRowRealMatrix(matrix, false);
    }

    int size() {
        return functions.length;
    }

    double minimumPhase() {
        return nodes.minimum();
    }

    double maximumPhase() {
        return nodes.maximum();
    }

    /** What the functions from {@code terms} on would have carried, root mean square. */
    double rootMeanSquareError(int terms) {
        double tail = 0;
        for (int n = terms; n < squares.length; n++) {
            tail += squares[n];
        }
        return Math.sqrt(tail);
    }

    /** c_n(zeta) for n from 0 to terms - 1. */
    double[] values(int terms, double zeta) {
        return nodes.interpolate(functions, terms, zeta);
    }

    /**
     * T_n(s) = mean over zeta of c_n(zeta) exp(-i zeta s) as sum_k (-i)^k a_nk T_k(s); returns the real numbers (-i)^k
     * a_nk without the i, so that even k are real parts and odd k imaginary parts.
     */
    double[][] chebyshevSeries(int terms) {
        int length = orderWhereCoefficientsVanish(maximumPhase());
        double[][] series = new double[terms][length];
        for (int q = 0; q < nodes.count(); q++) {
            double[] coefficients = bessel(length, nodes.node(q));
            for (int k = 0; k < length; k++) {
                // (-i)^k is 1, -i, -1, i.
                double sign = k % 4 == 0 || k % 4 == 3 ? 1 : -1;
                double bessel = sign * nodes.weight(q) * coefficients[k];
                for (int n = 0; n < terms; n++) {
                    series[n][k] += bessel * functions[n][q];
                }
            }
        }
        return series;
    }

    // Beyond the turning point n = zeta, J_n falls faster than exponentially; 12 zeta^(1/3) orders later it is below
    // 1e-17.
    private static int orderWhereCoefficientsVanish(double zeta) {
        return (int) Math.ceil(zeta + 12 * Math.cbrt(zeta) + 12);
    }

    /** Coefficients of exp(-i zeta s) over Chebyshev polynomials (Jacobi-Anger, DLMF 10.12.3): J_0 and 2 J_n(zeta). */
    static double[] bessel(int count, double zeta) {
        BesselJ.BesselJResult result = BesselJ.rjBesl(zeta, 0, count);
        double[] values = result.getVals();
        // Orders past the library's range of double numbers come back as not computed: they are zero.
        for (int n = 1; n < count; n++) {
            values[n] = n < result.getnVals() || result.getnVals() == count ? 2 * values[n] : 0;
        }
        return values;
    }
}
