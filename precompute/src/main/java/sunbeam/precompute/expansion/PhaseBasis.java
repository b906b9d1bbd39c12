package sunbeam.precompute.expansion;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.apache.commons.math3.special.BesselJ;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Orthonormal functions of the phase, in descending order of their singular values: the right singular vectors of the kernel exp(-i zeta
 * s), sampled at Gauss-Legendre nodes of the phase zeta and at the weighted heights of a {@link HeightRule}.
 */
final class PhaseBasis {
    private final PhaseNodes nodes;
    private final double[][] functions;
    private final double[] squaredSingularValues;

    private PhaseBasis(PhaseNodes nodes, HeightRule rule) {
        this.nodes = nodes;
        // The kernel's Gram matrix would lose half of the digits: where nearly no light is diffracted, errors of 1e-9
        // count. The kernel's triangular QR factor has few rows and the same singular values and right vectors.
        RealMatrix triangle = new QRDecomposition(kernel(rule)).getR();
        int last = nodes.count() - 1;
        SingularValueDecomposition decomposition =
                new SingularValueDecomposition(triangle.getSubMatrix(0, last, 0, last));
        squaredSingularValues = decomposition.getSingularValues();
        functions = new double[squaredSingularValues.length][nodes.count()];
        for (int n = 0; n < functions.length; n++) {
            squaredSingularValues[n] *= squaredSingularValues[n];
            for (int q = 0; q < nodes.count(); q++) {
                functions[n][q] = decomposition.getV().getEntry(q, n) / Math.sqrt(nodes.weight(q));
            }
        }
    }

    static PhaseBasis of(HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase) {
        // The bandwidth is 1, since |s| is at most 1.
        return new PhaseBasis(
                new PhaseNodes(minimumPhase, maximumPhase, 1), HeightRule.of(heights, scale, maximumPhase));
    }

    /** Real and imaginary parts of exp(-i zeta s) are separate rows, so that the functions of the phase are real. */
    private RealMatrix kernel(HeightRule rule) {
        int heights = rule.heights().length;
        // A QR decomposition needs at least as many rows as columns.
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

    /** Returns the error without the functions from index {@code terms} on. */
    double rootMeanSquareError(int terms) {
        double tail = 0;
        for (int n = terms; n < squaredSingularValues.length; n++) {
            tail += squaredSingularValues[n];
        }
        return Math.sqrt(tail);
    }

    double[] values(int terms, double zeta) {
        return nodes.interpolate(functions, terms, zeta);
    }

    /**
     * Returns the Chebyshev series of each basis function T_n(s), the mean over zeta of c_n(zeta) exp(-i zeta s): {@code [n][k]} multiplies
     * the Chebyshev polynomial of degree k; even k belong to the real part, odd k to the imaginary part.
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

    // Beyond n = zeta, the Bessel function J_n(zeta) falls faster than exponentially; 12 zeta^(1/3) orders later it is
    // below 1e-17.
    private static int orderWhereCoefficientsVanish(double zeta) {
        return (int) Math.ceil(zeta + 12 * Math.cbrt(zeta) + 12);
    }

    /** Returns J_0(zeta) and 2 J_n(zeta): exp(-i zeta s) in Chebyshev polynomials without factors (-i)^n (Jacobi-Anger, DLMF 10.12.3). */
    static double[] bessel(int count, double zeta) {
        BesselJ.BesselJResult result = BesselJ.rjBesl(zeta, 0, count);
        double[] values = result.getVals();
        // The library does not compute orders that underflow a double.
        for (int n = 1; n < count; n++) {
            values[n] = n < result.getnVals() || result.getnVals() == count ? 2 * values[n] : 0;
        }
        return values;
    }
}
