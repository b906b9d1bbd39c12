package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.Environment;

/** Each scene that comes with Sunbeam, as it is: what a user draws first. */
@NeedsDisplay
class BuiltInScenesTest {
    @TempDir
    private Path folder;

    @Test
    void allAreDrawnInColours() {
        SceneLoader loader = new SceneLoader(new Environment(Map.of(), folder), warning -> {});
        // Scenes of one patch share its tables.
        Map<String, SceneData> loaded = new HashMap<>();
        try (RenderContext context = RenderContexts.offscreen()) {
            for (String name : Scenes.builtIn()) {
                Scene scene = Scenes.load(name);
                String patch = scene.patch().toString();
                SceneData before = loaded.get(patch);
                SceneData data = before == null ? loader.load(scene) : loader.load(scene, before);
                loaded.put(patch, data);
                try (SceneSession session = new SceneSession(context, data)) {
                    float[] pixels = session.draw(24, 18).rgba();
                    assertThat(isColoured(pixels)).as(name).isTrue();
                }
            }
        }
    }

    /** Whether some pixel is far from the white of daylight. */
    private static boolean isColoured(float[] pixels) {
        for (int i = 0; i < pixels.length; i += 4) {
            float sum = pixels[i] + pixels[i + 1] + pixels[i + 2];
            // White has x = 0.313 and z = 0.358.
            if (sum > 0 && (Math.abs(pixels[i] / sum - 0.313) > 0.03 || Math.abs(pixels[i + 2] / sum - 0.358) > 0.03)) {
                return true;
            }
        }
        return false;
    }
}
