package sunbeam.precompute.expansion;

import org.apache.commons.math3.complex.Complex;

/** The expansions that Sunbeam knows. */
public enum ExpansionKind {
    /** Powers of the height: the thesis's choice (eq. 2.44). Its terms reach e^phase before they shrink. */
    TAYLOR(true),
    /** The singular vectors of the kernel over the heights that occur and the phases that are needed. */
    LOWRANK(false);

    private static final Complex[] POWERS_OF_MINUS_I = {Complex.ONE, Complex.I.negate(), Complex.ONE.negate(), Complex.I
    };

    private final boolean realBasis;

    ExpansionKind(boolean realBasis) {
        this.realBasis = realBasis;
    }

    /** Whether all T_n are real; then term n carries the factor (-i)^n, and two terms share one complex transform. */
    public boolean hasRealBasis() {
        return realBasis;
    }

    /** The constant factor of term n: (-i)^n for a real basis, 1 otherwise. */
    public Complex turn(int n) {
        return realBasis ? POWERS_OF_MINUS_I[n % 4] : Complex.ONE;
    }
}
