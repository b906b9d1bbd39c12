package sunbeam.precompute.expansion;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Orthonormal functions of the phase, best first, for the kernel exp(-i zeta s) weighted by the heights that occur: the
 * eigenvectors of its Gram matrix sum_s p(s) cos((zeta - zeta') s), discretised at Gauss-Legendre nodes.
 */
final class PhaseBasis {
    // Heights are binned for the Gram matrix alone; the shift of at most half a bin changes no error, only the
    // weighting.
    private static final int HISTOGRAM_BINS = 1024;

    private final PhaseNodes nodes;
    private final double[][] functions;
    private final double[] eigenvalues;

    private PhaseBasis(PhaseNodes nodes, double[] histogram) {
        this.nodes = nodes;
        // The singular value decomposition of a positive matrix is its eigendecomposition, best first; Commons Math's
        // solver for eigenvalues gives up where many of them are zero to the last digit.
        SingularValueDecomposition eigen = new SingularValueDecomposition(gram(histogram));
        eigenvalues = eigen.getSingularValues();
        functions = new double[nodes.count()][nodes.count()];
        for (int n = 0; n < nodes.count(); n++) {
            for (int q = 0; q < nodes.count(); q++) {
                functions[n][q] = eigen.getU().getEntry(q, n) / Math.sqrt(nodes.weight(q));
            }
        }
    }

    static PhaseBasis of(HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase) {
        double[] histogram = new double[HISTOGRAM_BINS];
        int[] counts = heights.histogram();
        double samples = heights.index().length;
        for (int i = 0; i < counts.length; i++) {
            long bin = Math.round((scale.scaled(heights.levels()[i]) + 1) / 2 * (HISTOGRAM_BINS - 1));
            histogram[(int) Math.min(HISTOGRAM_BINS - 1L, Math.max(0L, bin))] += counts[i] / samples;
        }
        // |s| is at most 1.
        return new PhaseBasis(new PhaseNodes(minimumPhase, maximumPhase, 1), histogram);
    }

    private RealMatrix gram(double[] histogram) {
        int count = nodes.count();
        double[][] matrix = new double[count][count];
        for (int a = 0; a < count; a++) {
            for (int b = 0; b <= a; b++) {
                double difference = nodes.node(a) - nodes.node(b);
                double sum = 0;
                for (int bin = 0; bin < HISTOGRAM_BINS; bin++) {
                    if (histogram[bin] > 0) {
                        sum += histogram[bin] * Math.cos(difference * (2.0 * bin / (HISTOGRAM_BINS - 1) - 1));
                    }
                }
                matrix[a][b] = sum * Math.sqrt(nodes.weight(a) * nodes.weight(b));
                matrix[b][a] = matrix[a][b];
            }
        }
        return new Array2DRowRealMatrix(matrix, false);
    }

    int size() {
        return nodes.count();
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
        for (int n = terms; n < eigenvalues.length; n++) {
            tail += eigenvalues[n];
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
        int length = ChebyshevExpansion.orderWhereCoefficientsVanish(maximumPhase());
        double[][] series = new double[terms][length];
        for (int q = 0; q < nodes.count(); q++) {
            double[] coefficients = ChebyshevExpansion.bessel(length, nodes.node(q));
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
}
