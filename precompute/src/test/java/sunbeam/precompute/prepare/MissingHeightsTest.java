package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Preparation.MissingHeights;

class MissingHeightsTest {
    private static final double NAN = Double.NaN;

    private static HeightMap map(int columns, int rows, double... heights) {
        return new HeightMap(columns, rows, 1e-9, 1e-9, heights);
    }

    @Test
    void leavesACompleteMapAlone() {
        HeightMap map = map(2, 2, 1, 2, 3, 4);

        MissingHeights.Filled filled = MissingHeights.fill(map);

        assertThat(filled.count()).isZero();
        assertThat(filled.field()).isSameAs(map);
    }

    @Test
    void fillsAHoleWithTheAverageOfItsNeighbors() {
        MissingHeights.Filled filled = MissingHeights.fill(map(3, 3, 1, 2, 3, 4, NAN, 6, 7, 8, 9));

        assertThat(filled.count()).isEqualTo(1);
        assertThat(filled.field().at(1, 1)).isEqualTo(5);
    }

    @Test
    void takesInfinitiesAsMissing() {
        MissingHeights.Filled filled =
                MissingHeights.fill(map(4, 1, Double.POSITIVE_INFINITY, 3, 5, Double.NEGATIVE_INFINITY));

        assertThat(filled.count()).isEqualTo(2);
        assertThat(filled.field().heights()).containsExactly(3, 3, 5, 5);
    }

    @Test
    void samplesOfOneRingDoNotSeeEachOther() {
        HeightMap filled =
                MissingHeights.fill(map(6, 1, 0, NAN, NAN, NAN, NAN, 8)).field();

        assertThat(filled.heights()).containsExactly(0, 0, 0, 8, 8, 8);
    }

    @Test
    void doesNotLookAcrossTheEdge() {
        HeightMap filled = MissingHeights.fill(map(4, 1, NAN, 1, 50, 100)).field();

        assertThat(filled.at(0, 0)).isEqualTo(1);
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
