package sunbeam.precompute.expansion;

import java.util.Arrays;

/** T_n = s^n, c_n = zeta^n / n! (thesis eq. 2.44), with heights scaled to [-1, 1]. */
public record TaylorExpansion(HeightScale scale, int terms, double maximumPhase) implements Expansion {

    /** The fewest terms whose remainder stays below a tolerance at the largest phase. */
    public static TaylorExpansion within(HeightScale scale, double maximumPhase, double tolerance) {
        int terms = 1;
        for (double remainder = maximumPhase; remainder > tolerance; remainder *= maximumPhase / terms) {
            terms++;
        }
        return new TaylorExpansion(scale, terms, maximumPhase);
    }

    @Override
    public ExpansionKind kind() {
        return ExpansionKind.TAYLOR;
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

    /** The largest coefficient: what cancels to leave a sum of magnitude 1. */
    public double largestTerm(double zeta) {
        return Arrays.stream(coefficients(zeta)).max().orElseThrow();
    }

    /** Lagrange's remainder with M = 1, because the argument is imaginary (the thesis's eq. 2.51 takes e^zeta). */
    public double errorBound(double zeta) {
        return coefficients(zeta)[terms - 1] * zeta / terms;
    }

    /** At the largest phase. */
    @Override
    public double error() {
        return errorBound(maximumPhase);
    }
}
