package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import jrtr.scene.View.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.text.Text;

/** Meshes much smaller and larger than the snake. */
@NeedsDisplay
class MeshSizesTest extends InAContext {
    private static final int SIDE = 16;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        // Sides of the square and distance of the eye, meters; whether it covers the picture's middle.
        "1e-12, 0.6, false",
        "1e-7,  0.6, false",
        "1e-7,  1e-7, true",
        "1,     1e6, false",
        "1e6,   1e6, true",
        "1,     1e-2, true"
    })
    void aMeshIsDrawnWhateverItsSizeAndDistance(double side, float distance, boolean covers) throws IOException {
        Path mesh = Files.writeString(
                folder.resolve("square.obj"),
                Text.format("v -%1$g -%1$g 0\nv %1$g -%1$g 0\nv %1$g %1$g 0\nv -%1$g %1$g 0\n", side / 2)
                        + "f 1 2 3 4\n");
        // Beside the middle, so that small meshes miss the center of a pixel.
        Camera camera = new Camera(new Vector3f(0, -0.1f * distance, distance), new Vector3f(), new Vector3f(0, 1, 0));
        Scene scene = PlaneScenes.blaze()
                .withMesh(MeshSource.of(mesh.toString()))
                .withView(new Viewpoint(camera, Math.toRadians(30)));
        try (SceneSession session = new SceneSession(context, PlaneScenes.load(scene, folder))) {
            ScenePicture picture = WholePicture.of(session, SIDE, SIDE);

            float alpha = picture.rgba()[4 * (SIDE / 2 * SIDE + SIDE / 2) + 3];
            assertThat(alpha).isEqualTo(covers ? 1 : 0);
            for (float value : picture.rgba()) {
                assertThat(value).isFinite();
            }
        }
    }
}
