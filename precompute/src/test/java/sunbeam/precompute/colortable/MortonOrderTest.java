package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

final class MortonOrderTest {
    @Test
    void eachCellOfASquareHasOneNumberOfTheFirstSoMany() {
        Set<Long> numbers = new HashSet<>();
        for (int y = 0; y < 128; y++) {
            for (int x = 0; x < 128; x++) {
                long number = MortonOrder.number(x, y);
                numbers.add(number);
                assertThat(MortonOrder.x((int) number)).isEqualTo(x);
                assertThat(MortonOrder.y((int) number)).isEqualTo(y);
            }
        }
        assertThat(numbers).hasSize(128 * 128).allMatch(number -> number >= 0 && number < 128 * 128);
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
    void largestCellsStillHaveNumbersOfTheirOwn() {
        int most = (1 << 15) - 1;
        assertThat(MortonOrder.number(most, most)).isEqualTo((1L << 30) - 1);
        assertThat(MortonOrder.number(most, 0)).isEqualTo(0x15555555L);
    }
}
