package sunbeam.precompute.expansion;

import org.apache.commons.math3.complex.Complex;

/** T_n = s^n, c_n = (-i zeta)^n / n! (thesis eq. 2.44), with heights scaled to [-1, 1]. */
public record TaylorExpansion(HeightScale scale, int terms, double maximumPhase) implements Expansion {
    private static final Complex[] POWERS_OF_MINUS_I = {Complex.ONE, Complex.I.negate(), Complex.ONE.negate(), Complex.I
    };

    @Override
    public ExpansionKind kind() {
        return ExpansionKind.TAYLOR;
    }

    @Override
    public boolean hasRealBasis() {
        return true;
    }

    @Override
    public Complex basis(int n, double s) {
        return new Complex(Math.pow(s, n));
    }

    @Override
    public Complex coefficient(int n, double zeta) {
        return POWERS_OF_MINUS_I[n % 4].multiply(magnitude(n, zeta));
    }

    private static double magnitude(int n, double zeta) {
        double value = 1;
        for (int m = 1; m <= n; m++) {
            value *= zeta / m;
        }
        return value;
    }

    /** Lagrange's remainder with M = 1, because the argument is imaginary (the thesis's eq. 2.51 takes e^zeta). */
    @Override
    public double errorBound(double zeta) {
        return Math.min(magnitude(terms, zeta), 1 + Math.exp(zeta));
    }
}
