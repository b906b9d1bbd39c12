package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import jrtr.Tile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.render.DrawRequest.SceneBlocks;
import sunbeam.app.render.PixelPicture.LitPixels;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;
import sunbeam.precompute.setting.Choices;

/** Samples of pixels, their means, and the lit ones among them. */
class PixelSamplesTest {
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
        assertThat(IntStream.range(0, side).map(row -> PixelSamples.firstColumn(row, side)))
                .hasSize(side)
                .doesNotHaveDuplicates()
                .allMatch(column -> column >= 0 && column < side)
                .satisfies(columns ->
                        assertThat(columns.stream().mapToInt(i -> i).average()).hasValue(0.5 * (side - 1)));
    }

    /** 5120 samples need three blocks of at most 2048, whose sides are no multiples of 4 unless they are rounded; 1300 pixels are prime to 4. */
    @ParameterizedTest
    @CsvSource({"1280,720,4", "1300,701,4", "480,270,6", "2060,24,1"})
    void aTileOfPixelsLiesInOneBlock(int width, int height, int side) {
        SceneBlocks blocks = SceneBlocks.of(side * width, side * height, side);
        for (Tile tile : blocks.tiles(side, 128)) {
            Tile samples = new Tile(side * tile.x(), side * tile.y(), side * tile.width(), side * tile.height());
            assertThat(blocks.split(samples)).as("%s", tile).hasSize(1);
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
        Arrays.fill(picture.rgba(), 4 * pixel, 4 * pixel + 3, light);
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
        LitPixels twoFrames = LitPixels.of(specks(0), CLIP).plus(LitPixels.of(specks(500), CLIP));
        assertThat(twoFrames.share()).isCloseTo(0.25, within(1e-12));
        // 1e-3 of white are three steps of 8 bits, as good as black.
        assertThat(LitPixels.of(specks(500), new DisplayTransform(1e-3, Tone.CLIP))
                        .lit())
                .isZero();
        assertThat(LitPixels.NONE.areTooFew()).isTrue();
        assertThat(LitPixels.NONE.complaint()).contains("shows no mesh");
    }

    @Test
    void theGroundDoesNotCountAsLightOfTheMesh() {
        ScenePicture samples = ScenePicture.empty(2, 2);
        for (int sample = 0; sample < 4; sample++) {
            set(samples, sample, sample == 0 ? 0.25f : 2, sample == 0 ? 1 : 0.75f);
        }

        ScenePicture pixel = samples.reduced(2);

        assertThat(pixel.linear().luminance(0)).isEqualTo(0.25f);
        assertThat(pixel.rgba()[3]).as("coverage").isEqualTo(0.25f);
    }

    private final PixelPicture pixels = new PixelPicture(2, 1, CLIP, new SceneColor(0));

    /** Two columns of four samples, one column for each pixel; the right one has a rim between its rows. */
    private static ScenePicture rim() {
        ScenePicture samples = ScenePicture.empty(2, 4);
        for (int i = 0; i < 8; i++) {
            set(samples, i, i % 2 == 1 && i >= 4 ? 0.5f : 0.2f, 1);
        }
        return samples;
    }

    @Test
    void samplesDifferAcrossARim() {
        BitSet differing = pixels.setAll(rim(), 1, 4);

        assertThat(differing.stream()).containsExactly(1);
        // A mean of two and two samples, within float32.
        assertThat(pixels.light().rgba()[4]).isCloseTo(0.35f, within(1e-6f));
    }

    @Test
    void onlyTheNamedPixelsChange() {
        pixels.setAll(rim(), 1, 4);
        int left = pixels.image().getRGB(0, 0);
        ScenePicture finer = ScenePicture.empty(4, 2);
        Arrays.fill(finer.rgba(), 1);
        BitSet right = new BitSet();
        right.set(1);

        assertThat(pixels.set(right, finer, 2, 2).isEmpty()).as("equal samples").isTrue();

        assertThat(pixels.image().getRGB(0, 0)).isEqualTo(left);
        assertThat(pixels.light().rgba()[0]).isCloseTo(0.2f, within(1e-6f));
        assertThat(pixels.light().rgba()[4]).isEqualTo(1);
    }
}
