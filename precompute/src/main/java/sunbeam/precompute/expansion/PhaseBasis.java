package sunbeam.precompute.expansion;

import java.util.Arrays;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import sunbeam.precompute.patch.HeightLevels;

/**
 * Orthonormal functions of the phase, best first, for the kernel exp(-i zeta s) weighted by the heights that occur: the
 * eigenvectors of its Gram matrix sum_s p(s) cos((zeta - zeta') s), discretised at Gauss-Legendre nodes. Between nodes
 * they are interpolated barycentrically, which is exact for functions of so little bandwidth.
 */
final class PhaseBasis {
    // Functions of |s| <= 1 need one node per pi of phase; the rest is for the digits.
    private static final int EXTRA_NODES = 28;
    // Heights are binned for the Gram matrix alone; the shift of at most half a bin changes no error, only the
    // weighting.
    private static final int HISTOGRAM_BINS = 1024;
    // A range of phases of no width (one direction, one wavelength) is widened by this.
    private static final double SMALLEST_RANGE = 1e-3;

    private final double[] nodes;
    private final double[] weights;
    private final double[] barycentric;
    private final double[][] functions;
    private final double[] eigenvalues;
    private final double minimumPhase;
    private final double maximumPhase;

    private PhaseBasis(double minimumPhase, double maximumPhase, double[][] histogram) {
        this.minimumPhase = minimumPhase;
        this.maximumPhase = Math.max(maximumPhase, minimumPhase + SMALLEST_RANGE);
        int count = EXTRA_NODES + (int) Math.ceil(this.maximumPhase - minimumPhase);
        nodes = new double[count];
        weights = new double[count];
        barycentric = new double[count];
        placeNodes();
        // The singular value decomposition of a positive matrix is its eigendecomposition, best first; Commons Math's
        // solver for eigenvalues gives up where many of them are zero to the last digit.
        SingularValueDecomposition eigen = new SingularValueDecomposition(gram(histogram));
        eigenvalues = eigen.getSingularValues();
        functions = new double[count][count];
        for (int n = 0; n < count; n++) {
            for (int q = 0; q < count; q++) {
                functions[n][q] = eigen.getU().getEntry(q, n) / Math.sqrt(weights[q]);
            }
        }
    }

    static PhaseBasis of(HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase) {
        double[][] histogram = new double[2][HISTOGRAM_BINS];
        int[] counts = heights.histogram();
        double samples = heights.index().length;
        for (int i = 0; i < counts.length; i++) {
            double s = scale.scaled(heights.levels()[i]);
            int bin = (int) Math.min(HISTOGRAM_BINS - 1L, Math.max(0L, Math.round((s + 1) / 2 * (HISTOGRAM_BINS - 1))));
            histogram[0][bin] += counts[i] / samples;
        }
        for (int bin = 0; bin < HISTOGRAM_BINS; bin++) {
            histogram[1][bin] = 2.0 * bin / (HISTOGRAM_BINS - 1) - 1;
        }
        return new PhaseBasis(minimumPhase, maximumPhase, histogram);
    }

    private void placeNodes() {
        // Commons Math makes Legendre rules of any order by recursion over all smaller ones; these orders stay small.
        GaussIntegrator rule = new GaussIntegratorFactory().legendre(nodes.length, -1, 1);
        for (int q = 0; q < nodes.length; q++) {
            double x = rule.getPoint(q);
            nodes[q] = minimumPhase + (x + 1) / 2 * (maximumPhase - minimumPhase);
            // Weights of a mean over the phases.
            weights[q] = rule.getWeight(q) / 2;
            // Berrut and Trefethen 2004, section 5, for Legendre points.
            barycentric[q] = (q % 2 == 0 ? 1 : -1) * Math.sqrt((1 - x * x) * rule.getWeight(q));
        }
    }

    private RealMatrix gram(double[][] histogram) {
        int count = nodes.length;
        double[][] matrix = new double[count][count];
        for (int a = 0; a < count; a++) {
            for (int b = 0; b <= a; b++) {
                double sum = 0;
                for (int bin = 0; bin < HISTOGRAM_BINS; bin++) {
                    if (histogram[0][bin] > 0) {
                        sum += histogram[0][bin] * Math.cos((nodes[a] - nodes[b]) * histogram[1][bin]);
                    }
                }
                matrix[a][b] = sum * Math.sqrt(weights[a] * weights[b]);
                matrix[b][a] = matrix[a][b];
            }
        }
        return new Array2DRowRealMatrix(matrix, false);
    }

    int size() {
        return nodes.length;
    }

    double minimumPhase() {
        return minimumPhase;
    }

    double maximumPhase() {
        return maximumPhase;
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
        double[] sums = new double[terms];
        double denominator = 0;
        for (int q = 0; q < nodes.length; q++) {
            double difference = zeta - nodes[q];
            if (difference == 0) {
                int node = q;
                Arrays.setAll(sums, n -> functions[n][node]);
                return sums;
            }
            double weight = barycentric[q] / difference;
            for (int n = 0; n < terms; n++) {
                sums[n] += weight * functions[n][q];
            }
            denominator += weight;
        }
        for (int n = 0; n < terms; n++) {
            sums[n] /= denominator;
        }
        return sums;
    }

    /**
     * T_n(s) = mean over zeta of c_n(zeta) exp(-i zeta s) as sum_k (-i)^k a_nk T_k(s); returns the real numbers (-i)^k
     * a_nk without the i, so that even k are real parts and odd k imaginary parts.
     */
    double[][] chebyshevSeries(int terms) {
        int length = ChebyshevExpansion.orderWhereCoefficientsVanish(maximumPhase);
        double[][] series = new double[terms][length];
        for (int q = 0; q < nodes.length; q++) {
            double[] coefficients = ChebyshevExpansion.bessel(length, nodes[q]);
            for (int k = 0; k < length; k++) {
                // (-i)^k is 1, -i, -1, i.
                double sign = k % 4 == 0 || k % 4 == 3 ? 1 : -1;
                double bessel = sign * weights[q] * coefficients[k];
                for (int n = 0; n < terms; n++) {
                    series[n][k] += bessel * functions[n][q];
                }
            }
        }
        return series;
    }
}
