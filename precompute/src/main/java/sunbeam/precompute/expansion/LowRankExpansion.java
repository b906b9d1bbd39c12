package sunbeam.precompute.expansion;

import sunbeam.precompute.patch.HeightLevels;

/**
 * The shortest expansion there is for one patch: singular vectors of exp(-i zeta s), weighted by how often each height
 * occurs, over the phases that a scene needs (Eckart and Young 1936). c_n are real and orthonormal over the phases; T_n
 * is the kernel's projection on c_n, held as a Chebyshev series.
 */
public final class LowRankExpansion implements Expansion {
    // Of the largest coefficient of all terms: a hundredth of a double's last digit.
    private static final double LOST = 1e-18;

    private final HeightScale scale;
    private final PhaseBasis phases;
    private final int terms;
    // Coefficients of T_0, T_2, ... and of T_1, T_3, ... of each term.
    private final double[][] even;
    private final double[][] odd;

    private LowRankExpansion(HeightScale scale, PhaseBasis phases, int terms) {
        this.scale = scale;
        this.phases = phases;
        this.terms = terms;
        double[][] series = phases.chebyshevSeries(terms);
        this.even = everySecond(series, 0);
        this.odd = everySecond(series, 1);
    }

    /**
     * The fewest terms whose error, root mean square over heights and phases, stays below a tolerance.
     *
     * @param tolerance at least 1e-7: the singular values come from a Gram matrix in double precision
     */
    public static LowRankExpansion within(
            HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase, double tolerance) {
        PhaseBasis phases = PhaseBasis.of(heights, scale, minimumPhase, maximumPhase);
        int terms = 1;
        while (terms < phases.size() && phases.rootMeanSquareError(terms) > tolerance) {
            terms++;
        }
        return new LowRankExpansion(scale, phases, terms);
    }

    /** The best expansion of a given number of terms. */
    public static LowRankExpansion ofTerms(
            HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase, int terms) {
        PhaseBasis phases = PhaseBasis.of(heights, scale, minimumPhase, maximumPhase);
        return new LowRankExpansion(scale, phases, Math.min(terms, phases.size()));
    }

    private static double[][] everySecond(double[][] series, int first) {
        int count = Math.max(1, (seenLength(series) + 1 - first) / 2);
        double[][] result = new double[series.length][count];
        for (int n = 0; n < series.length; n++) {
            for (int j = 0; j < count && 2 * j + first < series[n].length; j++) {
                result[n][j] = series[n][2 * j + first];
            }
        }
        return result;
    }

    /** Of as many coefficients as are not lost beside the largest. */
    private static int seenLength(double[][] series) {
        double largest = 0;
        int length = 1;
        for (double[] one : series) {
            for (double coefficient : one) {
                largest = Math.max(largest, Math.abs(coefficient));
            }
        }
        for (double[] one : series) {
            for (int k = length; k < one.length; k++) {
                if (Math.abs(one[k]) > LOST * largest) {
                    length = k + 1;
                }
            }
        }
        return length;
    }

    @Override
    public ExpansionKind kind() {
        return ExpansionKind.LOWRANK;
    }

    @Override
    public int terms() {
        return terms;
    }

    @Override
    public HeightScale scale() {
        return scale;
    }

    /** Even Chebyshev polynomials make the real part (Jacobi-Anger): with s = cos x, T_2j(s) = cos 2jx = T_j(y), y = 2 s^2 - 1. */
    @Override
    public double realBasis(int n, double s) {
        double y = 2 * s * s - 1;
        return clenshaw(even[n], y, y);
    }

    /** Odd ones make the imaginary part: T_2j+1(s) = s V_j(y), the Chebyshev polynomials of the third kind (DLMF 18.5.3). */
    @Override
    public double imaginaryBasis(int n, double s) {
        double y = 2 * s * s - 1;
        return s * clenshaw(odd[n], y, 2 * y - 1);
    }

    /** Clenshaw's sum of polynomials with p_0 = 1, a first one, and p_j+1 = 2 y p_j - p_j-1. */
    private static double clenshaw(double[] coefficients, double y, double first) {
        double next = 0;
        double afterNext = 0;
        for (int j = coefficients.length - 1; j >= 1; j--) {
            double value = 2 * y * next - afterNext + coefficients[j];
            afterNext = next;
            next = value;
        }
        return first * next - afterNext + coefficients[0];
    }

    @Override
    public double[] coefficients(double zeta) {
        return phases.values(terms, zeta);
    }

    @Override
    public double minimumPhase() {
        return phases.minimumPhase();
    }

    @Override
    public double maximumPhase() {
        return phases.maximumPhase();
    }

    /** Root mean square over the patch's heights and the phases. */
    @Override
    public double error() {
        return phases.rootMeanSquareError(terms);
    }
}
