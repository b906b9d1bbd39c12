package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import jrtr.Tile;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;

class RenderQueueTest {
    private static final PictureArea SQUARE = PictureArea.whole(100, 100);
    // 90 degrees: at distance d the picture reaches d to each side.
    private final Frustum frustum = new Frustum((float) Math.PI / 2, 1, 50);
    private final Camera camera = new Camera(new Vector3f(), new Vector3f(0, 0, -1), new Vector3f(0, 1, 0));
    private final Group root = new Group();

    private void put(String label, float radius, float x, float y, float z) {
        TransformGroup place = new TransformGroup(new Matrix4f().translate(x, y, z));
        place.add(new ShapeNode(FakeShapes.ball(label, radius)));
        root.add(place);
    }

    private RenderQueue queue(PictureArea area) {
        return RenderQueue.of(new GraphSceneManager(root, camera, frustum), area);
    }

    private static List<String> labels(RenderQueue queue) {
        return queue.items().stream()
                .map(item -> item.shape().vertices().label())
                .toList();
    }

    @Test
    void whatLiesOutsideAnyPlaneIsLeftOut() {
        // The right plane passes through (10, 0, -10) with normal (1, 0, 1) / sqrt 2: a centre at (13, 0, -10) lies
        // 3 / sqrt 2 = 2.12 outside.
        put("touches right", 2.2f, 13, 0, -10);
        put("beyond right", 2.05f, 13, 0, -10);
        put("beyond left", 2.05f, -13, 0, -10);
        put("beyond top", 2.05f, 0, 13, -10);
        put("beyond bottom", 2.05f, 0, -13, -10);
        put("before near", 0.5f, 0, 0, -0.4f);
        put("touches near", 0.7f, 0, 0, -0.4f);
        put("behind far", 1, 0, 0, -51.1f);
        put("touches far", 1, 0, 0, -50.9f);
        put("behind the eye", 1, 0, 0, 5);
        put("around the eye", 3, 0, 0, 1);

        assertThat(labels(queue(SQUARE)))
                .containsExactlyInAnyOrder("touches right", "touches near", "touches far", "around the eye");
    }

    @Test
    void nearestComesFirst() {
        put("far", 1, 0, 0, -30);
        put("near", 1, 0, 0, -5);
        put("large", 20, 0, 0, -26);

        assertThat(labels(queue(SQUARE))).containsExactly("near", "large", "far");
    }

    @Test
    void aTileNeedsOnlyWhatItShows() {
        put("top left", 0.5f, -5, 5, -10);
        put("bottom right", 0.5f, 5, -5, -10);

        assertThat(labels(queue(SQUARE.within(new Tile(0, 0, 50, 50))))).containsExactly("top left");
        assertThat(labels(queue(SQUARE.within(new Tile(50, 50, 50, 50))))).containsExactly("bottom right");
        assertThat(labels(queue(SQUARE.within(new Tile(40, 40, 5, 5))))).isEmpty();
    }

    @Test
    void aWidePictureSeesMoreToTheSides() {
        put("aside", 1, 15, 0, -10);

        assertThat(labels(queue(SQUARE))).isEmpty();
        assertThat(labels(queue(PictureArea.whole(200, 100)))).containsExactly("aside");
    }
}
