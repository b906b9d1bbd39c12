package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

final class MortonOrderTest {
    @Test
    void firstNumbersReachEachCellOfASquareOnce() {
        Set<Integer> cells = new HashSet<>();
        for (int number = 0; number < 128 * 128; number++) {
            assertThat(MortonOrder.x(number)).isBetween(0, 127);
            assertThat(MortonOrder.y(number)).isBetween(0, 127);
            cells.add(128 * MortonOrder.y(number) + MortonOrder.x(number));
        }
        assertThat(cells).hasSize(128 * 128);
    }

    @Test
    void fourNumbersThatFollowEachOtherAreASquareAndSoAreSixteen() {
        for (int first = 0; first < 4096; first += 16) {
            for (int i = 0; i < 16; i++) {
                assertThat(MortonOrder.x(first + i) >> 2).isEqualTo(MortonOrder.x(first) >> 2);
                assertThat(MortonOrder.y(first + i) >> 2).isEqualTo(MortonOrder.y(first) >> 2);
            }
        }
    }

    @Test
    void largestNumbersStillHaveCellsOfTheirOwn() {
        int most = (1 << 15) - 1;
        assertThat(MortonOrder.x((1 << 30) - 1)).isEqualTo(most);
        assertThat(MortonOrder.y((1 << 30) - 1)).isEqualTo(most);
        assertThat(MortonOrder.x(0x15555555)).isEqualTo(most);
        assertThat(MortonOrder.y(0x15555555)).isZero();
    }
}
