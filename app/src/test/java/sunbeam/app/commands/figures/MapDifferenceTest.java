package sunbeam.app.commands.figures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.picture.LinearPicture;

class MapDifferenceTest {
    private static final float NOTHING = Float.NaN;

    @Test
    void equalMapsDoNotDiffer() {
        LinearPicture map = new LinearPicture(2, 1, new float[] {0.2f, 0.3f, 0.1f, 0.4f, 0.5f, 0.6f});

        MapDifference difference = MapDifference.of(map, map, 1);

        assertThat(difference.medianRelative()).isZero();
        assertThat(difference.highCiede2000()).isZero();
    }

    @Test
    void theDifferenceIsRelativeToTheLargestComponentAndInvisiblePixelsDoNotCount() {
        LinearPicture base =
                new LinearPicture(3, 1, new float[] {0.2f, 0.4f, 0.1f, NOTHING, NOTHING, NOTHING, 0, 1e-5f, 0});
        LinearPicture map =
                new LinearPicture(3, 1, new float[] {0.2f, 0.4f, 0.14f, NOTHING, NOTHING, NOTHING, 1, 1, 1});

        MapDifference difference = MapDifference.of(map, base, 1);

        // 0.04 / 0.4 of float32 numbers
        assertThat(difference.medianRelative()).isCloseTo(0.1, within(1e-6));
        assertThat(difference.medianCiede2000()).isGreaterThan(1);
    }

    /** What is drawn as white in both does not look different. */
    @Test
    void aboveWhiteOnlyTheHueCounts() {
        LinearPicture base = new LinearPicture(1, 1, new float[] {2, 4, 6});
        LinearPicture map = new LinearPicture(1, 1, new float[] {4, 8, 12});

        MapDifference difference = MapDifference.of(map, base, 1);

        assertThat(difference.medianRelative()).isEqualTo(1);
        assertThat(difference.medianCiede2000()).isCloseTo(0, within(1e-9)); // the same numbers, rounded twice
    }
}
