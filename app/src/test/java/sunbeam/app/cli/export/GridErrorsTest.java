package sunbeam.app.cli.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

final class GridErrorsTest {
    private static final List<DirectionPair> AIMED = pairs(10);
    private static final List<DirectionPair> UNIFORM = pairs(40);

    /** Four, as many of them as twenty seconds allow, or as many as are given at any cost; half of them are on orders. */
    @ParameterizedTest
    @CsvSource({"1e6, , 4", "9.5e9, , 2", "1e12, , 1", "1e12, 6, 6", "1, 0, 0"})
    void costlyPairsAreFewUnlessTheirNumberIsGiven(double cost, Integer given, int compared) {
        assertThat(TableMetadata.GridErrors.choose(AIMED, UNIFORM, pair -> cost, Optional.ofNullable(given)))
                .isEqualTo(IntStream.range(0, compared)
                        .mapToObj(i -> (i % 2 == 0 ? AIMED : UNIFORM).get(i / 2))
                        .toList());
    }

    private static List<DirectionPair> pairs(double phiDegrees) {
        return IntStream.range(0, 8)
                .mapToObj(i -> new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDegrees(10 * i, phiDegrees)))
                .toList();
    }
}
