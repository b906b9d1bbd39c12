package sunbeam.app.cli.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

final class GridErrorsTest {
    private static final List<DirectionPair> AIMED = pairs(10);
    private static final List<DirectionPair> UNIFORM = pairs(40);

    @Test
    void aCheapSurfaceIsComparedAtFourPairsHalfOfThemOnOrders() {
        assertThat(GridErrors.choose(AIMED, UNIFORM, pair -> 1e6, Optional.empty()))
                .containsExactly(AIMED.get(0), UNIFORM.get(0), AIMED.get(1), UNIFORM.get(1));
    }

    @Test
    void aScanIsComparedAtAsManyPairsAsTwentySecondsAllow() {
        assertThat(GridErrors.choose(AIMED, UNIFORM, pair -> 9.5e9, Optional.empty()))
                .hasSize(2);
        assertThat(GridErrors.choose(AIMED, UNIFORM, pair -> 1e12, Optional.empty()))
                .hasSize(1);
    }

    @Test
    void aGivenNumberOfPairsIsComparedAtAnyCost() {
        assertThat(GridErrors.choose(AIMED, UNIFORM, pair -> 1e12, Optional.of(6)))
                .hasSize(6);
        assertThat(GridErrors.choose(AIMED, UNIFORM, pair -> 1, Optional.of(0))).isEmpty();
    }

    private static List<DirectionPair> pairs(double phiDegrees) {
        return IntStream.range(0, 8)
                .mapToObj(i -> new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDegrees(10 * i, phiDegrees)))
                .toList();
    }
}
