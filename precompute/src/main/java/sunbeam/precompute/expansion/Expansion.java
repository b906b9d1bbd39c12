package sunbeam.precompute.expansion;

import org.apache.commons.math3.complex.Complex;

/**
 * exp(i k w h) = exp(-i zeta s) = sum_n c_n(zeta) T_n(s), up to a constant phase, with s the scaled height
 * ({@link HeightScale}) and zeta = k |w| halfRange (w is never positive).
 */
public interface Expansion {

    /** How it is called at the command line and in files. */
    ExpansionKind kind();

    /** Number of terms, at least 1. */
    int terms();

    HeightScale scale();

    /** Whether all T_n are real; then two of them share one complex transform. */
    boolean hasRealBasis();

    /** T_n(s) for s in [-1, 1] and n from 0 to terms() - 1. */
    Complex basis(int n, double s);

    /** c_n(zeta) for zeta in 0..{@link #maximumPhase()}. */
    Complex coefficient(int n, double zeta);

    /** The largest phase that the expansion was made for. */
    double maximumPhase();

    /** Sampled c_n(zeta) where they have no closed form, null otherwise. */
    default CoefficientTable sampledCoefficients() {
        return null;
    }

    /** A bound of |exp(-i zeta s) - sum_n c_n T_n(s)| in exact arithmetic, for every s in [-1, 1]. */
    double errorBound(double zeta);
}
