package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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

/** Samples of pixels, their means, and the lit ones among them. */
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

    private static final DisplayTransform CLIP = new DisplayTransform(1, Tone.CLIP);

    /** A mesh of 1000 pixels, some of them white, beside as much white ground. */
    private static ScenePicture specks(int count) {
        ScenePicture picture = ScenePicture.empty(1000, 2);
        for (int pixel = 0; pixel < 1000; pixel++) {
            set(picture, pixel, pixel < count ? 1 : 0, 1);
            set(picture, 1000 + pixel, 1, 0.3f);
        }
        return picture.reduced(1);
    }

    private static void set(ScenePicture picture, int pixel, float light, float opacity) {
        for (int c = 0; c < 3; c++) {
            picture.rgba()[4 * pixel + c] = light;
        }
        picture.rgba()[4 * pixel + 3] = opacity;
    }

    @Test
    void aBlackMeshWithSpecksHasTooFewWhateverLiesAroundIt() {
        LitPixels specks = LitPixels.of(specks(12), CLIP);

        assertThat(specks.areTooFew()).isTrue();
        assertThat(specks.summary()).isEqualTo("lit: 1.2 % of 1000 pixels that the mesh fills");
        assertThat(specks.complaint()).contains("1.2 %", "move the light");
        assertThat(LitPixels.of(specks(50), CLIP).areTooFew()).isFalse();
        assertThat(LitPixels.of(specks(1000), CLIP).summary()).startsWith("lit: 100 % of");
    }

    @Test
    void pixelsThatCannotBeToldFromBlackAreDark() {
        // Three steps of 8 bits: 1e-3 of white.
        DisplayTransform dark = new DisplayTransform(1e-3, Tone.CLIP);

        assertThat(LitPixels.of(specks(500), dark).lit()).isZero();
    }

    @Test
    void sharesOfSeveralFramesAreMeans() {
        LitPixels both = LitPixels.of(specks(0), CLIP).plus(LitPixels.of(specks(500), CLIP));

        assertThat(both.share()).isCloseTo(0.25, within(1e-12));
    }

    @Test
    void aPictureWithoutTheMeshHasItsOwnComplaint() {
        assertThat(LitPixels.NONE.areTooFew()).isTrue();
        assertThat(LitPixels.NONE.complaint()).contains("shows no mesh");
    }

    @Test
    void theGroundDoesNotCountAsLightOfTheMesh() {
        ScenePicture samples = ScenePicture.empty(2, 2);
        for (int sample = 0; sample < 4; sample++) {
            boolean isMesh = sample == 0;
            for (int c = 0; c < 3; c++) {
                samples.rgba()[4 * sample + c] = isMesh ? 0.25f : 2;
            }
            samples.rgba()[4 * sample + 3] = isMesh ? 1 : 0.75f;
        }

        ScenePicture pixel = samples.reduced(2);

        assertThat(pixel.linear().luminance(0)).isEqualTo(0.25f);
        assertThat(pixel.rgba()[3]).as("coverage").isEqualTo(0.25f);
    }
}
