package sunbeam.precompute.spectrum;

import java.util.Arrays;
import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.setting.ValueKind;

/**
 * Expansion of exp(i k w h) = exp(-i zeta s), up to a constant phase. Each term is a function of direction and wavelength times a function
 * of the height:
 *
 * <pre>exp(-i zeta s) = sum_n (-i)^turns(n) c_n(zeta) T_n(s)</pre>
 *
 * with s the scaled height ({@link HeightScale}), zeta = k |w| halfRange (w is never positive) and real c_n.
 */
public interface Expansion {
    enum Kind {
        /** Powers of the height: the thesis's choice (eq. 2.44). Its terms reach e^phase before they shrink. */
        TAYLOR,
        /** Singular vectors of the kernel exp(-i zeta s) over the patch's heights and the phases that a scene needs. */
        LOWRANK;

        private static final Complex[] POWERS_OF_MINUS_I = {
            Complex.ONE, Complex.I.negate(), Complex.ONE.negate(), Complex.I
        };

        /** True if all T_n are real; then term n has the factor (-i)^n, and two terms share one complex transform. */
        public boolean hasRealBasis() {
            return this == TAYLOR;
        }

        /** Returns the constant factor of term n: (-i)^n for a real basis, 1 otherwise. */
        public Complex turn(int n) {
            return hasRealBasis() ? POWERS_OF_MINUS_I[n % 4] : Complex.ONE;
        }
    }

    Kind kind();

    int terms();

    HeightScale scale();

    /** Returns the real part of T_n(s) for s in [-1, 1] and n from 0 to terms() - 1. */
    double realBasis(int n, double s);

    default double imaginaryBasis(int n, double s) {
        return 0;
    }

    /** Returns all c_n(zeta), n from 0 to terms() - 1, for zeta in {@link #minimumPhase()}..{@link #maximumPhase()}. */
    double[] coefficients(double zeta);

    /** Smallest and largest phase zeta at which the expansion is accurate, radians. */
    default double minimumPhase() {
        return 0;
    }

    double maximumPhase();

    /** Returns the error of the sum in exact arithmetic: an upper bound or a root mean square, depending on the kind. */
    double error();

    default String key() {
        return ValueKind.name(kind()) + "|" + terms() + "|" + scale() + "|" + minimumPhase() + "|" + maximumPhase();
    }

    /** Taylor series: T_n = s^n, c_n = zeta^n / n! (thesis eq. 2.44), with heights scaled to [-1, 1]. */
    record TaylorExpansion(HeightScale scale, int terms, double maximumPhase) implements Expansion {
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
        @Override
        public double error() {
            return coefficients(maximumPhase)[terms - 1] * maximumPhase / terms;
        }
    }
}
