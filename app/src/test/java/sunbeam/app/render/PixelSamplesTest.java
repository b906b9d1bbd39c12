package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.setting.Choices;

class PixelSamplesTest {
    private static final SceneMethod TABLE = new SceneMethod(Choices.none());

    /** 480 x 270 had 5 x 5, 16 % fewer in all, and missed its own certificate by a mean CIEDE2000 of 1.1. */
    @ParameterizedTest
    @CsvSource({"480,270", "320,240", "800,600", "1000,500", "1200,800", "3000,2000"})
    void aSmallPictureHasNoFewerSamplesInAllThanALargeOne(int width, int height) {
        int samples = PixelSamples.alongSide(TABLE, width, height);

        assertThat((long) samples * samples * width * height).isGreaterThanOrEqualTo(4L * 1280 * 720);
        assertThat(samples).isBetween(2, PixelSamples.MOST);
    }

    /** A third sample along a side costs 17 % of the time of `render elaphe --size 1280x720`. */
    @Test
    void aPictureOf1280By720HasFourSamplesAPixel() {
        assertThat(PixelSamples.alongSide(TABLE, 1280, 720)).isEqualTo(2);
    }

    @Test
    void aPictureOf480By270HasThirtySixSamplesAPixel() {
        assertThat(PixelSamples.alongSide(TABLE, 480, 270)).isEqualTo(6);
    }
}
