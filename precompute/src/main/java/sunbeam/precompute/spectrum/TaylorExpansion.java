package sunbeam.precompute.spectrum;

import java.util.Arrays;

/** Taylor series: T_n = s^n, c_n = zeta^n / n! (thesis eq. 2.44), with heights scaled to [-1, 1]. */
public record TaylorExpansion(HeightScale scale, int terms, double maximumPhase) implements Expansion {
    /** Returns the fewest terms whose remainder at the largest phase is within a tolerance. */
    public static TaylorExpansion within(HeightScale scale, double maximumPhase, double tolerance) {
        int terms = 1;
        for (double remainder = maximumPhase; remainder > tolerance; remainder *= maximumPhase / terms) {
            terms++;
        }
        return new TaylorExpansion(scale, terms, maximumPhase);
    }

    @Override
    public Kind kind() {
        return Kind.TAYLOR;
    }

    @Override
    public double realBasis(int n, double s) {
        return Math.pow(s, n);
    }

    @Override
    public double[] coefficients(double zeta) {
        double[] values = new double[terms];
        values[0] = 1;
        for (int n = 1; n < terms; n++) {
            values[n] = values[n - 1] * zeta / n;
        }
        return values;
    }

    /** Terms of this size cancel to a sum of magnitude 1. */
    public double largestTerm(double zeta) {
        return Arrays.stream(coefficients(zeta)).max().orElseThrow();
    }

    /** Returns Lagrange's bound of the remainder: derivatives are at most 1, where the thesis's eq. 2.51 takes e^zeta. */
    public double errorBound(double zeta) {
        return coefficients(zeta)[terms - 1] * zeta / terms;
    }

    @Override
    public double error() {
        return errorBound(maximumPhase);
    }
}
