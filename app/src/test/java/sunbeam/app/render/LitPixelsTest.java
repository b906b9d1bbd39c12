package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;

class LitPixelsTest {
    private static final DisplayTransform DISPLAY = new DisplayTransform(1, Tone.CLIP);

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
        LitPixels specks = LitPixels.of(specks(12), DISPLAY);

        assertThat(specks.areTooFew()).isTrue();
        assertThat(specks.summary()).isEqualTo("lit: 1.2 % of 1000 pixels that the mesh fills");
        assertThat(specks.complaint()).contains("1.2 %", "move the light");
        assertThat(LitPixels.of(specks(50), DISPLAY).areTooFew()).isFalse();
        assertThat(LitPixels.of(specks(1000), DISPLAY).summary()).startsWith("lit: 100 % of");
    }

    @Test
    void pixelsThatCannotBeToldFromBlackAreDark() {
        // Three steps of 8 bits: 1e-3 of white.
        DisplayTransform dark = new DisplayTransform(1e-3, Tone.CLIP);

        assertThat(LitPixels.of(specks(500), dark).lit()).isZero();
    }

    @Test
    void sharesOfSeveralFramesAreMeans() {
        LitPixels both = LitPixels.of(specks(0), DISPLAY).plus(LitPixels.of(specks(500), DISPLAY));

        assertThat(both.share()).isCloseTo(0.25, within(1e-12));
    }

    @Test
    void aPictureWithoutTheMeshHasItsOwnComplaint() {
        assertThat(LitPixels.NONE.areTooFew()).isTrue();
        assertThat(LitPixels.NONE.complaint()).contains("shows no mesh");
    }
}
