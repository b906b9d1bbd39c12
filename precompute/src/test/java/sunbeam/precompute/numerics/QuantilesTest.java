package sunbeam.precompute.numerics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

final class QuantilesTest {
    @Test
    void theEndsAreTheExtremesAndBetweenNeighborsItIsLinear() {
        double[] samples = {4, 1, 3, 2};
        assertThat(Quantiles.of(samples, 0)).isEqualTo(1);
        assertThat(Quantiles.of(samples, 0.25)).isEqualTo(1.75);
        assertThat(Quantiles.of(samples, 0.5)).isEqualTo(2.5);
        assertThat(Quantiles.of(samples, 1)).isEqualTo(4);
        assertThat(samples).containsExactly(4, 1, 3, 2);
    }

    @Test
    void infiniteSamplesCountOnlyWhereTheyAreReached() {
        double infinite = Double.POSITIVE_INFINITY;
        assertThat(Quantiles.of(new double[] {infinite, 1, 2}, 0.5)).isEqualTo(2);
        assertThat(Quantiles.of(new double[] {infinite, 1, 2}, 0.51)).isInfinite();
        assertThat(Quantiles.of(new double[] {infinite, 1, infinite}, 0.75)).isInfinite();
    }

    @Test
    void emptySetsHaveNoStatistics() {
        assertThat(Quantiles.of(new double[0], 0)).isNaN();
        assertThat(Quantiles.of(new double[0], 0.5)).isNaN();
    }
}
