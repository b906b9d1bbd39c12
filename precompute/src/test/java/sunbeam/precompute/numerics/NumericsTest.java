package sunbeam.precompute.numerics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.spectrum.PhaseNodes.GaussLegendre;

final class NumericsTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 28, 700, 3000})
    void gaussLegendreIntegratesTheHighestPolynomialsOfARule(int count) {
        GaussLegendre rule = GaussLegendre.of(count);
        for (int degree : new int[] {0, count / 2 * 2, 2 * count - 2}) {
            double sum = IntStream.range(0, count)
                    .mapToDouble(i -> rule.weights()[i] * Math.pow(rule.nodes()[i], degree))
                    .sum();
            // Rounding of so many digits in nodes near 1, to a power of thousands.
            assertThat(sum).isCloseTo(2.0 / (degree + 1), within(1e-13));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.5, -0.2, 0, 0.3, 0.5})
    void theParabolaOfLogarithmsFindsTheTopOfAGaussian(double top) {
        DoubleUnaryOperator gaussian = x -> 3 * Math.exp(-0.7 * (x - top) * (x - top));
        assertThat(Lagrange.top(gaussian.applyAsDouble(-1), gaussian.applyAsDouble(0), gaussian.applyAsDouble(1)))
                // Exact but for the rounding of the logarithms.
                .isCloseTo(top, within(1e-14));
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1, 0", "2, 1, 2, 0", "0, 1, 0.5, 0", "1, 2, 3, 0.5"})
    void withoutATopItIsTheMiddleAndWithinHalfAStep(double before, double here, double after, double top) {
        assertThat(Lagrange.top(before, here, after)).isEqualTo(top);
    }

    @Test
    void quantilesAreLinearBetweenNeighborsAndLeaveTheSamples() {
        double[] samples = {4, 1, 3, 2};
        double[] quantiles = DoubleStream.of(0, 0.25, 0.5, 1)
                .map(share -> Quantiles.of(samples, share))
                .toArray();
        assertThat(quantiles).containsExactly(1, 1.75, 2.5, 4);
        assertThat(samples).containsExactly(4, 1, 3, 2);
        assertThat(Quantiles.of(new double[0], 0)).isNaN();
        assertThat(Quantiles.of(new double[0], 0.5)).isNaN();
    }

    @Test
    void infiniteSamplesCountOnlyWhereTheyAreReached() {
        double infinite = Double.POSITIVE_INFINITY;
        assertThat(Quantiles.of(new double[] {infinite, 1, 2}, 0.5)).isEqualTo(2);
        assertThat(Quantiles.of(new double[] {infinite, 1, 2}, 0.51)).isInfinite();
        assertThat(Quantiles.of(new double[] {infinite, 1, infinite}, 0.75)).isInfinite();
    }
}
