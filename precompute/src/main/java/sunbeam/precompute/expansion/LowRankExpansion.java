package sunbeam.precompute.expansion;

import org.apache.commons.math3.complex.Complex;
import sunbeam.precompute.patch.HeightLevels;

/**
 * The shortest expansion there is for one patch: singular vectors of exp(-i zeta s), weighted by how often each height
 * occurs, over the phases that a scene needs (Eckart and Young 1936). c_n are real and orthonormal over the phases; T_n
 * is the kernel's projection on c_n, held as a Chebyshev series.
 */
public final class LowRankExpansion implements Expansion {
    // The bound looks at this many heights at most, extremes included.
    private static final int BOUND_SAMPLES = 4096;

    private final HeightScale scale;
    private final PhaseBasis phases;
    private final int terms;
    private final double[][] series;
    private final HeightLevels heights;

    private LowRankExpansion(HeightScale scale, PhaseBasis phases, int terms, HeightLevels heights) {
        this.scale = scale;
        this.phases = phases;
        this.terms = terms;
        this.series = phases.chebyshevSeries(terms);
        this.heights = heights;
    }

    /**
     * The fewest terms whose error, root mean square over heights and phases, stays below a tolerance.
     *
     * @param tolerance at least 1e-7: the singular values come from a Gram matrix in double precision
     */
    public static LowRankExpansion within(
            HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase, double tolerance) {
        PhaseBasis phases = PhaseBasis.of(heights, scale, minimumPhase, maximumPhase);
        int terms = 1;
        while (terms < phases.size() && phases.rootMeanSquareError(terms) > tolerance) {
            terms++;
        }
        return new LowRankExpansion(scale, phases, terms, heights);
    }

    /** The best expansion of a given number of terms. */
    public static LowRankExpansion ofTerms(
            HeightLevels heights, HeightScale scale, double minimumPhase, double maximumPhase, int terms) {
        PhaseBasis phases = PhaseBasis.of(heights, scale, minimumPhase, maximumPhase);
        return new LowRankExpansion(scale, phases, Math.min(terms, phases.size()), heights);
    }

    /** Some of the heights that occur, scaled. */
    private double[] occurring() {
        int count = Math.min(BOUND_SAMPLES, heights.count());
        double[] result = new double[count];
        for (int i = 0; i < count; i++) {
            int level = count == 1 ? 0 : (int) ((long) i * (heights.count() - 1) / (count - 1));
            result[i] = scale.scaled(heights.levels()[level]);
        }
        return result;
    }

    @Override
    public ExpansionKind kind() {
        return ExpansionKind.LOWRANK;
    }

    @Override
    public int terms() {
        return terms;
    }

    @Override
    public HeightScale scale() {
        return scale;
    }

    /** Even Chebyshev polynomials make the real part, odd ones the imaginary part (Jacobi-Anger), by Clenshaw. */
    @Override
    public Complex basis(int n, double s) {
        double[] coefficients = series[n];
        double real = 0;
        double imaginary = 0;
        for (int parity = 0; parity <= 1; parity++) {
            double next = 0;
            double afterNext = 0;
            for (int k = coefficients.length - 1; k >= 1; k--) {
                double value = 2 * s * next - afterNext + (k % 2 == parity ? coefficients[k] : 0);
                afterNext = next;
                next = value;
            }
            double sum = s * next - afterNext + (parity == 0 ? coefficients[0] : 0);
            if (parity == 0) {
                real = sum;
            } else {
                imaginary = sum;
            }
        }
        return new Complex(real, imaginary);
    }

    @Override
    public double[] coefficients(double zeta) {
        return phases.values(terms, zeta);
    }

    @Override
    public double minimumPhase() {
        return phases.minimumPhase();
    }

    @Override
    public double maximumPhase() {
        return phases.maximumPhase();
    }

    /** Root mean square over the patch's heights and the phases. */
    public double rootMeanSquareError() {
        return phases.rootMeanSquareError(terms);
    }

    /** The largest error at the heights that occur. */
    @Override
    public double errorBound(double zeta) {
        double worst = 0;
        for (double s : occurring()) {
            Complex exact = new Complex(Math.cos(zeta * s), -Math.sin(zeta * s));
            worst = Math.max(worst, exact.subtract(sum(zeta, s)).abs());
        }
        return worst;
    }
}
