package sunbeam.precompute.expansion;

import java.util.Locale;

/** The expansions that Sunbeam knows. */
public enum ExpansionKind {
    /** Powers of the height: the thesis's choice (eq. 2.44). Its terms reach e^phase before they shrink. */
    TAYLOR,
    /** Jacobi-Anger: Chebyshev polynomials with Bessel coefficients, of at most 2. */
    CHEBYSHEV,
    /** The singular vectors of the kernel over the heights that occur and the phases that are needed. */
    LOWRANK;

    /** Lower-case name, as at the command line and in files. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
