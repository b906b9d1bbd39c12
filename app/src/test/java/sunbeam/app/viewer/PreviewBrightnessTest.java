package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.nio.file.Path;
import java.util.Map;
import jrtr.RenderContext;
import jrtr.Tile;
import jrtr.gl.RenderContexts;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.setting.Choices;

@NeedsDisplay
class PreviewBrightnessTest {
    private static final int WIDTH = 240;
    private static final int HEIGHT = 180;

    @TempDir
    private Path folder;

    /** A shorter coherence length spreads the same light over a wider angle; on a curved skin its sum stays. */
    @Test
    void previewsAreAsBrightAndAsColoredAsFinalPictures() {
        Scene scales = Scenes.load("elaphe-scales")
                .with(Choices.none().with(METHOD, FullMethod.TYPE).with(TOLERANCE, 0.02));
        Scene scene = scales.withBlend(new Blend(scales.blend().diffraction(), 0, 0, 0));
        LoadedScene loaded =
                LoadedScene.load(new SceneLoader(new Environment(Map.of(), folder), line -> {}), scene, null);
        assertThat(loaded.coarse().scene().method().get(COHERENCE_LENGTH))
                .isLessThan(scene.method().get(COHERENCE_LENGTH));
        try (RenderContext context = RenderContexts.offscreen()) {
            double[] fine = mean(context, loaded.fine());
            double[] coarse = mean(context, loaded.coarse());
            for (int c = 0; c < 3; c++) {
                // Peaks are narrower than these pixels on the scales, so that each mean depends a little on where the
                // pixels lie; without the windows' areas there would be a factor of 4.
                assertThat(coarse[c]).isCloseTo(fine[c], Percentage.withPercentage(5));
            }
        }
    }

    private static double[] mean(RenderContext context, SceneData data) {
        try (SceneSession session = new SceneSession(context, data)) {
            ScenePicture picture = session.draw(WIDTH, HEIGHT, Tile.whole(WIDTH, HEIGHT));
            double[] sum = new double[3];
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                for (int c = 0; c < 3; c++) {
                    sum[c] += picture.rgba()[4 * i + c];
                }
            }
            return sum;
        }
    }
}
