package sunbeam.precompute.expansion;

import org.apache.commons.math3.complex.Complex;

/** Kind of an expansion of exp(i k w h). */
public enum ExpansionKind {
    /** Powers of the height: the thesis's choice (eq. 2.44). Its terms reach e^phase before they shrink. */
    TAYLOR(true),
    /** Singular vectors of the kernel exp(-i zeta s) over the patch's heights and the phases that a scene needs. */
    LOWRANK(false);

    private static final Complex[] POWERS_OF_MINUS_I = {Complex.ONE, Complex.I.negate(), Complex.ONE.negate(), Complex.I
    };

    private final boolean realBasis;

    ExpansionKind(boolean realBasis) {
        this.realBasis = realBasis;
    }

    /** True if all T_n are real; then term n has the factor (-i)^n, and two terms share one complex transform. */
    public boolean hasRealBasis() {
        return realBasis;
    }

    /** Returns the constant factor of term n: (-i)^n for a real basis, 1 otherwise. */
    public Complex turn(int n) {
        return realBasis ? POWERS_OF_MINUS_I[n % 4] : Complex.ONE;
    }
}
