package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import jrtr.RenderContext;
import jrtr.Tile;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;

@NeedsDisplay
class ScenePreviewTest {
    private static final int WIDTH = 145;
    private static final int HEIGHT = 110;
    // Float32 in two shaders.
    private static final float ROUNDING = 1e-6f;

    @TempDir
    private Path folder;

    private static ScenePicture filled(int width, int height, float x, float y, float z) {
        ScenePicture picture = ScenePicture.empty(width, height);
        for (int i = 0; i < width * height; i++) {
            System.arraycopy(new float[] {x, y, z, 1}, 0, picture.rgba(), 4 * i, 4);
        }
        return picture;
    }

    @Test
    void aFinerBodyIsThatOfTheWholePicture() {
        Scene scene = PlaneScenes.blaze().withBlend(new Blend(0, 0.6, 0.7, 0.2)).withTexture("elaphe");
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(context, PlaneScenes.load(scene, folder))) {
            ScenePreview preview = session.preview(WIDTH, HEIGHT, 16);
            assertThat(preview.bodyIsFiner()).isTrue();
            float[] body = session.draw(WIDTH / 5, HEIGHT / 5).rgba();
            float[] shown = preview.picture().rgba();
            assertThat(shown).hasSameSizeAs(body);
            for (int i = 0; i < body.length; i++) {
                assertThat(shown[i]).isCloseTo(body[i], within(ROUNDING));
            }
            assertThat(preview.fixed(preview.diffractionNanoseconds() + 5)).isEqualTo(5);
        }
    }

    @Test
    void atThatResolutionThePreviewIsThePicture() {
        Scene scene = PlaneScenes.blaze().withBlend(new Blend(30, 0.6, 0.7, 0.2));
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(context, PlaneScenes.load(scene, folder))) {
            ScenePreview preview = session.preview(WIDTH, HEIGHT, 5);
            assertThat(preview.bodyIsFiner()).isFalse();
            Tile whole = Tile.whole(WIDTH / 5, HEIGHT / 5);
            assertThat(preview.picture().rgba())
                    .isEqualTo(session.draw(WIDTH / 5, HEIGHT / 5, whole).rgba());
            assertThat(preview.fixed(123_456)).isEqualTo(preview.meshNanoseconds());
        }
    }

    @Test
    void lightIsLaidOverTheBodyAsTheShaderBlendsThem() {
        ScenePicture body = filled(8, 6, 0.3f, 0.2f, 0.1f);
        float[] faint = ScenePreview.composed(body, filled(2, 2, 0.5f, 0.5f, 0.25f), 2, 2)
                .rgba();
        // Light of intensity 2: an opacity of 0.5 / 2.
        assertThat(Arrays.copyOf(faint, 4)).containsExactly(0.5f + 0.75f * 0.3f, 0.65f, 0.325f, 1);
        float[] glaring =
                ScenePreview.composed(body, filled(2, 2, 900, 300, 600), 1, 1).rgba();
        // Cut at white, in its color; the body is not seen.
        assertThat(Arrays.copyOf(glaring, 4)).containsExactly(3, 1, 2, 1);
    }

    @Test
    void whereTheFewPixelsShowNoSkinNothingIsAddedAndNothingIsLost() {
        ScenePicture body = filled(8, 4, 0.3f, 0.2f, 0.1f);
        body.rgba()[3] = 0;
        ScenePicture light = ScenePicture.empty(2, 1);
        System.arraycopy(new float[] {0.5f, 0.5f, 0.5f, 1}, 0, light.rgba(), 4, 4);
        ScenePicture preview = ScenePreview.composed(body, light, 1, 1);
        assertThat(Arrays.copyOf(preview.rgba(), 4)).as("background").containsOnly(0);
        // At the left only the pixel without skin is near; from its middle on, the other's light counts whole.
        assertThat(preview.rgba()[4 + 1]).isEqualTo(0.2f);
        assertThat(preview.rgba()[4 * 4 + 1]).isCloseTo(0.5f + 0.5f * 0.2f, within(ROUNDING));
    }

    @Test
    void lightChangesEvenlyBetweenPixelsMiddles() {
        ScenePicture picture = filled(2, 1, 0, 0, 0);
        picture.rgba()[5] = 1;
        float[] sample = new float[4];
        for (double column : new double[] {0, 0.25, 0.5, 1}) {
            picture.sample(column, 0, sample);
            assertThat(sample[1]).isCloseTo((float) column, within(ROUNDING));
        }
        picture.sample(-0.5, -0.5, sample);
        assertThat(sample).containsExactly(0, 0, 0, 1);
    }
}
