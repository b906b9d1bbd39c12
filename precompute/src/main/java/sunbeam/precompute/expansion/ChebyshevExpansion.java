package sunbeam.precompute.expansion;

import org.apache.commons.math3.special.BesselJ;

/**
 * Jacobi-Anger: T_n the Chebyshev polynomials, c_n = (2 - [n = 0]) J_n(zeta) (DLMF 10.12.3). No coefficient exceeds 2,
 * so nothing cancels.
 */
public record ChebyshevExpansion(HeightScale scale, int terms, double maximumPhase) implements Expansion {

    /** The fewest terms whose remainder stays below a tolerance at the largest phase. */
    public static ChebyshevExpansion within(HeightScale scale, double maximumPhase, double tolerance) {
        double[] coefficients = bessel(orderWhereCoefficientsVanish(maximumPhase), maximumPhase);
        double remainder = 0;
        int terms = coefficients.length;
        while (terms > 1) {
            remainder += Math.abs(coefficients[terms - 1]);
            if (remainder > tolerance) {
                break;
            }
            terms--;
        }
        return new ChebyshevExpansion(scale, terms, maximumPhase);
    }

    // Beyond the turning point n = zeta, J_n falls faster than exponentially; 12 zeta^(1/3) orders later it is below
    // 1e-17.
    static int orderWhereCoefficientsVanish(double zeta) {
        return (int) Math.ceil(zeta + 12 * Math.cbrt(zeta) + 12);
    }

    /** J_0 and 2 J_n(zeta) for n from 1 to count - 1. */
    static double[] bessel(int count, double zeta) {
        BesselJ.BesselJResult result = BesselJ.rjBesl(zeta, 0, count);
        double[] values = result.getVals();
        // Orders past the library's range of double numbers come back as not computed: they are zero.
        for (int n = 1; n < count; n++) {
            values[n] = n < result.getnVals() || result.getnVals() == count ? 2 * values[n] : 0;
        }
        return values;
    }

    @Override
    public ExpansionKind kind() {
        return ExpansionKind.CHEBYSHEV;
    }

    @Override
    public double realBasis(int n, double s) {
        return Math.cos(n * Math.acos(Math.min(1, Math.max(-1, s))));
    }

    @Override
    public double[] coefficients(double zeta) {
        return bessel(terms, zeta);
    }

    /** What is left out, with every polynomial at its largest. */
    public double errorBound(double zeta) {
        double[] coefficients = bessel(Math.max(terms, orderWhereCoefficientsVanish(zeta)), zeta);
        double sum = 0;
        for (int n = coefficients.length - 1; n >= terms; n--) {
            sum += Math.abs(coefficients[n]);
        }
        return sum;
    }

    /** At the largest phase. */
    @Override
    public double error() {
        return errorBound(maximumPhase);
    }
}
