package sunbeam.precompute.numerics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GaussLegendreTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 28, 700, 3000})
    void theHighestPolynomialsOfARuleAreIntegratedExactlyHoweverManyNodes(int count) {
        GaussLegendre rule = GaussLegendre.of(count);
        for (int degree : new int[] {0, count / 2 * 2, 2 * count - 2}) {
            double sum = IntStream.range(0, count)
                    .mapToDouble(i -> rule.weights()[i] * Math.pow(rule.nodes()[i], degree))
                    .sum();
            // Rounding of so many digits in nodes near 1, to a power of thousands.
            assertThat(sum).isCloseTo(2.0 / (degree + 1), within(1e-13));
        }
    }
}
