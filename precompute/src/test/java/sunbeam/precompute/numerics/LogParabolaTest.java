package sunbeam.precompute.numerics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

final class LogParabolaTest {
    @Test
    void findsTheTopOfAGaussian() {
        for (double top : new double[] {-0.5, -0.2, 0, 0.3, 0.5}) {
            DoubleUnaryOperator gaussian = x -> 3 * Math.exp(-0.7 * (x - top) * (x - top));
            assertThat(LogParabola.top(
                            gaussian.applyAsDouble(-1), gaussian.applyAsDouble(0), gaussian.applyAsDouble(1)))
                    // Exact but for the rounding of the logarithms.
                    .isCloseTo(top, within(1e-14));
        }
    }

    @Test
    void withoutATopItIsTheMiddle() {
        assertThat(LogParabola.top(1, 1, 1)).isZero();
        assertThat(LogParabola.top(2, 1, 2)).as("a valley").isZero();
        assertThat(LogParabola.top(0, 1, 0.5)).as("no logarithm").isZero();
    }

    @Test
    void staysWithinHalfAStep() {
        assertThat(LogParabola.top(1, 2, 3)).isEqualTo(0.5);
    }
}
