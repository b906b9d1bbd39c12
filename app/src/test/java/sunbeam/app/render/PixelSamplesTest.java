package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.BitSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;
import sunbeam.precompute.setting.Choices;

class PixelSamplesTest {
    private static final DisplayTransform DISPLAY = new DisplayTransform(1, Tone.COMPRESS);

    /** 480 x 270 had 5 x 5, 16 % fewer in all, and missed its own certificate by a mean CIEDE2000 of 1.1. */
    @ParameterizedTest
    @CsvSource({"320,240,8", "480,270,6", "640,360,4", "1280,720,4", "3000,2000,4"})
    void aSmallPictureHasMoreSamplesAPixel(int width, int height, int side) {
        assertThat(PixelSamples.of(new SceneMethod(Choices.none()), width, height))
                .isEqualTo(new PixelSamples(side, true));
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 6, 8})
    void theFirstSamplesShareNoRowAndNoColumnAndTheirMeanIsThePixelsCenter(int side) {
        BitSet first = new PixelSamples(side, true).first(side, side);

        assertThat(first.stream().map(i -> i / side).distinct().count()).isEqualTo(side);
        assertThat(first.stream().map(i -> i % side).distinct().count()).isEqualTo(side);
        assertThat(first.stream().map(i -> i % side).average()).hasValue(0.5 * (side - 1));
    }

    /** The left one of two pixels is flat, the right one has a rim between its rows. */
    @Test
    void onlyAPixelWhoseFirstSamplesDifferNeedsAllSamples() {
        PixelSamples samples = new PixelSamples(4, true);
        ScenePicture picture = ScenePicture.empty(8, 4);
        samples.first(8, 4).stream()
                .forEach(i -> Arrays.fill(picture.rgba(), 4 * i, 4 * i + 4, i % 8 >= 4 && i >= 16 ? 0.5f : 0.2f));

        BitSet needed = samples.spread(picture, DISPLAY, new SceneColor(0));

        assertThat(needed.stream().map(i -> i % 8)).hasSize(16).allMatch(column -> column >= 4);
        for (int i = 0; i < 32; i++) {
            assertThat(picture.rgba()[4 * i]).isEqualTo(i % 8 >= 4 && i >= 16 ? 0.5f : 0.2f);
        }
    }
}
