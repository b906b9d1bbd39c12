package sunbeam.precompute.expansion;

import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.setting.Kinds;

/**
 * exp(i k w h) = exp(-i zeta s), up to a constant phase, as a sum that separates direction from surface:
 *
 * <pre>exp(-i zeta s) = sum_n (-i)^turns(n) c_n(zeta) T_n(s)</pre>
 *
 * with s the scaled height ({@link HeightScale}), zeta = k |w| halfRange (w is never positive) and real c_n.
 */
public interface Expansion {

    /** How it is called at the command line and in files, and its quarter turns. */
    ExpansionKind kind();

    /** Number of terms, at least 1. */
    int terms();

    HeightScale scale();

    /** Real part of T_n(s) for s in [-1, 1] and n from 0 to terms() - 1. */
    double realBasis(int n, double s);

    /** Imaginary part of T_n(s); none where {@link ExpansionKind#hasRealBasis()}. */
    default double imaginaryBasis(int n, double s) {
        return 0;
    }

    /** T_n(s). */
    default Complex basis(int n, double s) {
        return new Complex(realBasis(n, s), imaginaryBasis(n, s));
    }

    /** All c_n(zeta), n from 0 to terms() - 1, for zeta in {@link #minimumPhase()}..{@link #maximumPhase()}. */
    double[] coefficients(double zeta);

    /** The smallest phase that the expansion was made for. */
    default double minimumPhase() {
        return 0;
    }

    /** The largest phase that the expansion was made for. */
    double maximumPhase();

    /** Error of the sum in exact arithmetic that a plan is made by. */
    double error();

    /** Which expansion of a patch's heights it is, as text; numbers are written so that no two of them are written alike. */
    default String key() {
        return String.join(
                "|",
                Kinds.name(kind()),
                Integer.toString(terms()),
                scale().toString(),
                Double.toString(minimumPhase()),
                Double.toString(maximumPhase()));
    }
}
