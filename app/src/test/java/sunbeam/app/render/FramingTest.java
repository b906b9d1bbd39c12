package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import jrtr.VertexData.BoundingSphere;
import jrtr.scene.View;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.BuiltInMeshes;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.precompute.setting.Choices;

/** What a scene frames, and the wireframe that a first preview shows. */
class FramingTest {
    private static final Mesh SNAKE = BuiltInMeshes.create("snake");

    @ParameterizedTest
    @CsvSource({"800, 600", "870, 811", "600, 600", "300, 1200", "2000, 500", "16, 9000"})
    void theWholeSnakeIsInThePicture(int width, int height) {
        for (String name : new String[] {"elaphe", "xenopeltis"}) {
            float[] reach = reach(Scenes.load(name), width, height);
            assertThat(reach[0]).as("%s, left and right", name).isLessThan(1);
            assertThat(reach[1]).as("%s, bottom and top", name).isLessThan(1);
            // The snake spans at least half of one side.
            assertThat(Math.max(reach[0], reach[1])).as("%s, larger", name).isGreaterThan(0.5f);
        }
    }

    @ParameterizedTest
    @CsvSource({"870, 811", "300, 1200"})
    void narrowPicturesHaveTheHorizontalAngleOfFourToThree(int width, int height) {
        Scene scene = Scenes.load("elaphe-scales");

        // Float32.
        assertThat(reach(scene, width, height)[0]).isCloseTo(reach(scene, 800, 600)[0], withinPercentage(1e-3));
    }

    /** Greatest distance of the mesh from the middle along x and y, in halves of the picture. */
    private static float[] reach(Scene scene, int width, int height) {
        Matrix4f toClip = Framing.view(scene.view(), new BoundingSphere(new Vector3f(), 1))
                .worldToClip(View.Area.whole(width, height));
        float[] reach = new float[2];
        Vector3f point = new Vector3f();
        for (int vertex = 0; vertex < SNAKE.vertices(); vertex++) {
            point.set(
                    SNAKE.positions()[3 * vertex],
                    SNAKE.positions()[3 * vertex + 1],
                    SNAKE.positions()[3 * vertex + 2]);
            toClip.transformProject(point);
            reach[0] = Math.max(reach[0], Math.abs(point.x));
            reach[1] = Math.max(reach[1], Math.abs(point.y));
        }
        return reach;
    }

    private static final int SIDE = 200;

    /** Strokes along a sphere's normals, 3 % of its radius long, make its outline wider by 3 %. */
    @Test
    void normalsPointOutwards() {
        Scene scene = Scenes.load("elaphe").with(Choices.none().with(SceneSettings.MESH, "sphere"));

        double ratio = width(scene, true) / width(scene, false);

        // Two pixels of 200, and the perspective enlarges nearer parts.
        assertThat(ratio).isCloseTo(1.03, within(0.012));
    }

    private static double width(Scene scene, boolean normals) {
        BufferedImage image = LineDrawings.wireframe(scene, scene.mesh().load().mesh(), normals, SIDE, SIDE);
        int[] columns = IntStream.range(0, SIDE)
                .filter(x -> IntStream.range(0, SIDE).anyMatch(y -> image.getRGB(x, y) != image.getRGB(0, 0)))
                .toArray();
        return columns[columns.length - 1] - columns[0];
    }
}
