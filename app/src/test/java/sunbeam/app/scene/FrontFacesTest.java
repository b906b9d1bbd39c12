package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import jrtr.scene.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.Mesh;

/** Of a closed body half the triangles are drawn, and nobody sees it. */
@NeedsDisplay
class FrontFacesTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;

    @TempDir
    private Path folder;

    private RenderContext context;

    @BeforeEach
    void open() {
        context = RenderContexts.offscreen();
    }

    @AfterEach
    void close() {
        context.close();
    }

    private static Scene body(String mesh, Vector3f eye) {
        double degrees = eye.length() > 0.5 ? 20 : 60;
        return PlaneScenes.blaze()
                .withMesh(mesh)
                .withBlend(new Blend(30, 0.6, 0.7, 0.2))
                .withOrientation(new Quaternionf().rotationXYZ(0.3f, 0.5f, 0.2f))
                .withView(
                        new Viewpoint(new Camera(eye, new Vector3f(), new Vector3f(0, 1, 0)), Math.toRadians(degrees)));
    }

    private float[] picture(SceneData data) {
        try (SceneSession session = new SceneSession(context, data)) {
            return session.draw(WIDTH, HEIGHT).rgba();
        }
    }

    private static SceneData withBothSides(SceneData data) {
        Mesh mesh = data.mesh();
        Mesh open = new Mesh(
                mesh.positions(), mesh.normals(), mesh.tangents(), mesh.textureCoordinates(), mesh.indices(), false);
        return new SceneData(
                data.scene(), open, data.patch(), data.method(), data.tables(), data.levels(), data.body());
    }

    @ParameterizedTest
    @ValueSource(strings = {"snake", "sphere"})
    void fromOutsideABodyIsTheSameWithoutTheBacksOfItsTriangles(String mesh) {
        SceneData data = PlaneScenes.load(body(mesh, new Vector3f(-0.2f, -0.3f, 0.7f)), folder);
        assertThat(data.mesh().closed()).isTrue();

        float[] fronts = picture(data);
        float[] both = picture(withBothSides(data));

        int different = 0;
        int covered = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            boolean same = true;
            for (int channel = 4 * pixel; channel < 4 * pixel + 4; channel++) {
                same &= fronts[channel] == both[channel];
            }
            different += same ? 0 : 1;
            covered += both[4 * pixel + 3] > 0 ? 1 : 0;
        }
        assertThat(covered).isGreaterThan(1000);
        // At an outline front and back meet: where the depth buffer cannot tell them apart, the one drawn first is
        // seen.
        assertThat(different).isLessThanOrEqualTo(covered / 500);
    }

    @Test
    void fromInsideTheBacksAreSeen() {
        SceneData data = PlaneScenes.load(body("sphere", new Vector3f(0.02f, 0.01f, 0.03f)), folder);
        float[] picture = picture(data);

        assertThat(picture).isEqualTo(picture(withBothSides(data)));
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            assertThat(picture[4 * pixel + 3]).as("a wall all around").isGreaterThan(0);
        }
    }

    @Test
    void whatIsOpenHasTwoSides() {
        assertThat(BuiltInMeshes.create("plane").closed()).isFalse();
        assertThat(BuiltInMeshes.create("cylinder").closed()).isFalse();
    }
}
