package sunbeam.precompute.expansion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.patch.HeightLevels;

class ExpansionTest {
    // Rounding of sums of some hundred terms of at most 2.
    private static final double ROUNDING = 1e-12;
    private static final double[] SHARES = {0.26, 0.5, 0.77, 1};

    private static HeightLevels heights(double relief) {
        return HeightLevels.of(Surfaces.of(64, 64, 50e-9, (x, y) -> relief * Math.pow(Math.sin(4e6 * x + 1e6 * y), 2)));
    }

    private static Complex sum(Expansion expansion, double zeta, double s) {
        double[] coefficients = expansion.coefficients(zeta);
        Complex sum = Complex.ZERO;
        for (int n = 0; n < coefficients.length; n++) {
            sum = sum.add(
                    expansion.kind().turn(n).multiply(expansion.basis(n, s)).multiply(coefficients[n]));
        }
        return sum;
    }

    private static double measured(Expansion expansion, HeightLevels heights, double zeta) {
        double worst = 0;
        for (double height : heights.levels()) {
            double s = expansion.scale().scaled(height);
            Complex exact = new Complex(Math.cos(zeta * s), -Math.sin(zeta * s));
            worst = Math.max(worst, exact.subtract(sum(expansion, zeta, s)).abs());
        }
        return worst;
    }

    @ParameterizedTest
    @ValueSource(doubles = {50e-9, 250e-9, 375e-9, 819e-9, 2e-6, 5e-6})
    void measuredErrorsStayBelowTheBound(double relief) {
        HeightLevels heights = heights(relief);
        HeightScale scale = HeightScale.midRange(heights);
        double maximum = scale.phase(380e-9, 2);
        for (LowRankExpansion expansion : List.of(
                LowRankExpansion.within(heights, scale, 0, maximum, 1e-3),
                LowRankExpansion.within(heights, scale, maximum / 4, maximum, 1e-5))) {
            for (double share : SHARES) {
                assertThat(measured(expansion, heights, share * maximum))
                        .as("of all heights, beside the root mean square of heights and phases")
                        .isLessThanOrEqualTo(20 * expansion.error() + ROUNDING);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {50e-9, 250e-9, 375e-9})
    void taylorStaysBelowItsBoundWhereItDoesNotCancel(double relief) {
        HeightLevels heights = heights(relief);
        HeightScale scale = HeightScale.midRange(heights);
        TaylorExpansion expansion = TaylorExpansion.within(scale, scale.phase(380e-9, 2), 1e-3);
        for (double share : new double[] {0.3, 0.6, 1}) {
            double zeta = share * expansion.maximumPhase();
            // Terms reach e^zeta, at most e^6.2 = 500 here, and lose as many digits of double precision.
            assertThat(measured(expansion, heights, zeta)).isLessThanOrEqualTo(expansion.errorBound(zeta) + 1e-12);
        }
    }

    @Test
    void lagrangeBoundOfAnImaginaryArgumentNeedsNoExponential() {
        // Thesis eq. 2.51 at x = 1.5 pi and N = 20, with M = 1 in place of e^x: 2.7e-6.
        TaylorExpansion taylor = new TaylorExpansion(new HeightScale(0, 1e-6), 20, 1.5 * Math.PI);
        double thesis = Math.exp(1.5 * Math.PI);
        assertThat(thesis).isCloseTo(111.3, within(0.1));
        double worst = 0;
        for (double s = -1; s <= 1; s += 0.01) {
            Complex exact = new Complex(Math.cos(1.5 * Math.PI * s), -Math.sin(1.5 * Math.PI * s));
            worst = Math.max(
                    worst, exact.subtract(sum(taylor, 1.5 * Math.PI, s)).abs());
        }
        double bound = taylor.errorBound(1.5 * Math.PI);
        assertThat(worst).isLessThanOrEqualTo(bound);
        // The bound is tight within the next term's factor; the thesis's is 111 times larger.
        assertThat(worst * 10).isGreaterThan(bound);
    }
}
