package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;

class LevelingTest {
    private static final double OFFSET = 1e-3;
    /** Doubles near 1 mm have steps of 2.2e-19 m, which remain after a subtraction. */
    private static final double ROUNDING_OF_OFFSET = 2.2e-19;

    private static HeightMap map(int columns, int rows, Surfaces.Samples samples) {
        return Surfaces.sampled(columns, rows, 50e-9, samples);
    }

    private static double mean(HeightMap map) {
        return Arrays.stream(map.heights()).average().orElseThrow();
    }

    private static double largest(HeightMap map) {
        return Math.max(Math.abs(map.minimum()), Math.abs(map.maximum()));
    }

    @Test
    void meanSurvivesAnOffsetOfAMillimeter() {
        Random random = new Random(3);
        double[] relief = random.doubles(200 * 100, 0, 400e-9).toArray();
        double mean = Arrays.stream(relief).average().orElseThrow();
        HeightMap leveled = Leveling.MEAN.apply(map(200, 100, (c, r) -> OFFSET + relief[r * 200 + c]));

        for (int i = 0; i < relief.length; i++) {
            // Half a unit for rounding the height, and as much for each of the two means.
            assertThat(leveled.at(i % 200, i / 200) - (relief[i] - mean))
                    .isBetween(-2 * ROUNDING_OF_OFFSET, 2 * ROUNDING_OF_OFFSET);
        }
        // The second pass sums 2e4 values below 1e-6 m, relative rounding 1e-16 each.
        assertThat(mean(leveled)).isBetween(-1e-20, 1e-20);
    }

    @ParameterizedTest
    @CsvSource({"64, 48", "1, 37", "37, 1", "2, 2", "1, 2"})
    void planeRemovesATiltUnderAMillimeterOfOffset(int columns, int rows) {
        HeightMap tilted = map(columns, rows, (c, r) -> OFFSET + 3e-9 * c - 7e-9 * r);

        // Half a unit of the samples' rounding, and a few operations on 1e-7 m.
        assertThat(largest(Leveling.PLANE.apply(tilted))).isLessThan(2 * ROUNDING_OF_OFFSET);
    }

    @Test
    void planeLevelingLeavesTheRest() {
        // A product of two odd ramps has neither mean nor slope on a centered grid.
        Surfaces.Samples saddle = (c, r) -> 1e-9 * (c - 10) * (r - 7);
        HeightMap leveled = Leveling.PLANE.apply(map(21, 15, (c, r) -> saddle.at(c, r) + 5e-9 * c + 2e-9 * r));

        for (int r = 0; r < 15; r++) {
            for (int c = 0; c < 21; c++) {
                // Heights are below 3e-7 m, some ten roundings of relative 1e-16 each.
                assertThat(leveled.at(c, r) - saddle.at(c, r)).isBetween(-1e-21, 1e-21);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"MEAN", "PLANE"})
    void missingSamplesTakeNoPartAndStayMissing(Leveling leveling) {
        HeightMap map =
                map(9, 9, (c, r) -> c >= 5 && r >= 5 ? Double.NaN : 4e-9 * (leveling == Leveling.PLANE ? c : 1));
        HeightMap leveled = leveling.apply(map);

        assertThat(largest(leveled)).isLessThan(1e-22);
        assertThat(Arrays.stream(leveled.heights()).filter(Double::isNaN).count())
                .isEqualTo(16);
    }

    @Test
    void planeTakesTheSlopeAlongTheLineWhenOnlyALineIsKnown() {
        HeightMap diagonal = map(5, 5, (c, r) -> c == r ? 2e-9 * c : Double.NaN);

        assertThat(largest(Leveling.PLANE.apply(diagonal))).isLessThan(1e-23);
    }

    @ParameterizedTest
    @EnumSource
    void acceptsAMapWithoutAnySample(Leveling leveling) {
        HeightMap nothing = map(3, 3, (c, r) -> Double.NaN);

        assertThat(leveling.apply(nothing).heights()).containsOnly(Double.NaN);
    }
}
