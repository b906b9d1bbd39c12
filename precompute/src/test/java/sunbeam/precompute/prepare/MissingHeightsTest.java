package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Preparation.MissingHeights;

class MissingHeightsTest {
    private static final double NAN = Double.NaN;

    private static HeightMap map(int columns, int rows, double... heights) {
        return new HeightMap(columns, rows, 1e-9, 1e-9, heights);
    }

    /** Infinities are missing; samples of one ring do not see each other; none is seen across the edge. */
    @ParameterizedTest
    @CsvSource({
        "3, 1 2 3 4 NaN 6 7 8 9, 1 2 3 4 5 6 7 8 9",
        "4, Infinity 3 5 -Infinity, 3 3 5 5",
        "6, 0 NaN NaN NaN NaN 8, 0 0 0 8 8 8",
        "4, NaN 1 50 100, 1 1 50 100"
    })
    void holesHaveTheAverageOfTheirNeighbors(int columns, String heights, String expected) {
        double[] given = numbers(heights);
        MissingHeights.Filled filled = MissingHeights.fill(map(columns, given.length / columns, given));
        assertThat(filled.field().heights()).containsExactly(numbers(expected));
        assertThat(filled.count()).isEqualTo((int)
                Arrays.stream(given).filter(h -> !Double.isFinite(h)).count());
    }

    private static double[] numbers(String text) {
        return Arrays.stream(text.split(" ", -1))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    @Test
    void fillsHolesOfAnyShapeWithoutLeavingTheRangeOfHeights() {
        Random random = new Random(5);
        double[] heights = new double[61 * 47];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = random.nextInt(10) == 0 ? 1e-3 + random.nextDouble() : NAN;
        }
        double[] filled = MissingHeights.fill(map(61, 47, heights)).field().heights();

        double least = Arrays.stream(heights).filter(Double::isFinite).min().orElseThrow();
        double most = Arrays.stream(heights).filter(Double::isFinite).max().orElseThrow();
        for (int i = 0; i < heights.length; i++) {
            // An average of up to eight numbers near 1 may leave their range by its rounding.
            assertThat(filled[i]).isBetween(least - 1e-15, most + 1e-15);
            assertThat(Double.isNaN(heights[i]) || filled[i] == heights[i]).isTrue();
        }
    }

    @Test
    void fillsAVeryLargeHoleFromOneSample() {
        double[] heights = new double[1000 * 1000];
        Arrays.fill(heights, NAN);
        heights[0] = 7;

        MissingHeights.Filled filled = MissingHeights.fill(map(1000, 1000, heights));

        assertThat(filled.count()).isEqualTo(999_999);
        assertThat(filled.field().heights()).containsOnly(7);
    }

    @Test
    void refusesAMapWithoutAnySample() {
        assertThatThrownBy(() -> MissingHeights.fill(map(2, 2, NAN, NAN, NAN, NAN)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("all 4 samples are missing");
    }
}
