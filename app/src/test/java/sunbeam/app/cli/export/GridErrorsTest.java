package sunbeam.app.cli.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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

    /** As many as twenty seconds allow, or as are given at any cost. */
    @ParameterizedTest
    @CsvSource({"9.5e9, , 2", "1e12, , 1", "1e12, 6, 6", "1, 0, 0"})
    void costlyPairsAreFewUnlessTheirNumberIsGiven(double cost, Integer given, int compared) {
        assertThat(GridErrors.choose(AIMED, UNIFORM, pair -> cost, Optional.ofNullable(given)))
                .hasSize(compared);
    }

    private static List<DirectionPair> pairs(double phiDegrees) {
        return IntStream.range(0, 8)
                .mapToObj(i -> new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDegrees(10 * i, phiDegrees)))
                .toList();
    }
}
