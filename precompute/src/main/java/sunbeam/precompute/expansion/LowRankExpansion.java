package sunbeam.precompute.expansion;

import sunbeam.precompute.patch.HeightLevels;

/**
 * Expansion with the fewest terms for one patch: singular vectors of the kernel exp(-i zeta s), with heights weighted by their number of
 * samples, over the phases that a scene needs (Eckart and Young 1936). The c_n are real and orthonormal over the phases; T_n is stored as a
 * Chebyshev series.
 */
public final class LowRankExpansion implements Expansion {
    // Relative to the largest coefficient of all terms: a hundredth of a double's rounding.
    private static final double SMALLEST_SIGNIFICANT = 1e-18;

    private final HeightScale scale;
    private final PhaseBasis phases;
    private final int terms;
    // [term][j]: coefficients of the Chebyshev polynomials of degree 2 j, and of degree 2 j + 1.
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

    /** Returns the expansion with the fewest terms whose root mean square error over heights and phases is within a tolerance. */
    public static LowRankExpansion within(
            HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase, double tolerance) {
        PhaseBasis phases = PhaseBasis.of(heights, scale, minimumPhase, maximumPhase);
        int terms = 1;
        while (terms < phases.size() && phases.rootMeanSquareError(terms) > tolerance) {
            terms++;
        }
        return new LowRankExpansion(scale, phases, terms);
    }

    /** Returns the expansion with the smallest error for this number of terms. */
    public static LowRankExpansion ofTerms(
            HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase, int terms) {
        PhaseBasis phases = PhaseBasis.of(heights, scale, minimumPhase, maximumPhase);
        return new LowRankExpansion(scale, phases, Math.min(terms, phases.size()));
    }

    private static double[][] everySecond(double[][] series, int first) {
        int count = Math.max(1, (significantLength(series) + 1 - first) / 2);
        double[][] result = new double[series.length][count];
        for (int n = 0; n < series.length; n++) {
            for (int j = 0; j < count && 2 * j + first < series[n].length; j++) {
                result[n][j] = series[n][2 * j + first];
            }
        }
        return result;
    }

    /** Up to the last significant coefficient of any term. */
    private static int significantLength(double[][] series) {
        double largest = 0;
        int length = 1;
        for (double[] one : series) {
            for (double coefficient : one) {
                largest = Math.max(largest, Math.abs(coefficient));
            }
        }
        for (double[] one : series) {
            for (int k = length; k < one.length; k++) {
                if (Math.abs(one[k]) > SMALLEST_SIGNIFICANT * largest) {
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

    /**
     * Sums the even Chebyshev polynomials, which are the real part (Jacobi-Anger): with s = cos x and C_m the Chebyshev polynomial of
     * degree m, C_2j(s) = cos 2jx = C_j(y), y = 2 s^2 - 1.
     */
    @Override
    public double realBasis(int n, double s) {
        double y = 2 * s * s - 1;
        return clenshaw(even[n], y, y);
    }

    /** Sums the odd Chebyshev polynomials, the imaginary part: C_2j+1(s) = s V_j(y), V_j of the third kind (DLMF 18.5.3). */
    @Override
    public double imaginaryBasis(int n, double s) {
        double y = 2 * s * s - 1;
        return s * clenshaw(odd[n], y, 2 * y - 1);
    }

    /** Sums c_j p_j by Clenshaw's recurrence, for polynomials with p_0 = 1, p_1 = {@code first} and p_j+1 = 2 y p_j - p_j-1. */
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

    @Override
    public double error() {
        return phases.rootMeanSquareError(terms);
    }
}
