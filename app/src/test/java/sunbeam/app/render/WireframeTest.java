package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.setting.Choices;

class WireframeTest {
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
        BufferedImage image = Wireframe.draw(scene, scene.mesh().load().mesh(), normals, SIDE, SIDE);
        int[] columns = IntStream.range(0, SIDE)
                .filter(x -> IntStream.range(0, SIDE).anyMatch(y -> image.getRGB(x, y) != image.getRGB(0, 0)))
                .toArray();
        return columns[columns.length - 1] - columns[0];
    }
}
