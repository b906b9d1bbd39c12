package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;

class GraphTest {
    private static final Camera CAMERA = new Camera(new Vector3f(0, -5, 0), new Vector3f(), new Vector3f(0, 0, 1));
    private static final Frustum FRUSTUM = new Frustum(1, 0.1f, 100);

    private static GraphSceneManager scene(Node root) {
        return new GraphSceneManager(root, CAMERA, FRUSTUM);
    }

    private static List<RenderItem> items(Node root) {
        List<RenderItem> items = new ArrayList<>();
        scene(root).shapes().forEachRemaining(items::add);
        return items;
    }

    private static String label(RenderItem item) {
        return item.shape().vertices().label();
    }

    private static ShapeNode ball(String label) {
        return new ShapeNode(FakeShapes.ball(label, 1));
    }

    @Test
    void shapesComeDepthFirstInTheOrderInWhichTheyWereAdded() {
        Group root = new Group();
        Group first = new Group();
        Group second = new TransformGroup(new Matrix4f());
        root.add(ball("a"));
        root.add(first);
        root.add(new Group());
        root.add(second);
        root.add(ball("f"));
        first.add(ball("b"));
        first.add(second);
        second.add(ball("c"));
        second.add(ball("d"));

        assertThat(items(root).stream().map(GraphTest::label)).containsExactly("a", "b", "c", "d", "c", "d", "f");
        assertThat(items(new Group())).isEmpty();
        assertThat(items(ball("alone"))).hasSize(1);
    }

    @Test
    void anExhaustedIteratorSaysSo() {
        Iterator<RenderItem> empty = scene(new Group()).shapes();

        assertThat(empty.hasNext()).isFalse();
        assertThatThrownBy(empty::next).isInstanceOf(NoSuchElementException.class);
    }

    @Test
    void transformationsMultiplyFromTheTopDown() {
        Matrix4f outer = new Matrix4f().translate(1, 2, 3);
        Matrix4f inner = new Matrix4f().rotateZ(0.5f).scale(2);
        TransformGroup root = new TransformGroup(outer);
        TransformGroup child = new TransformGroup(inner);
        root.add(child);
        child.add(ball("a"));
        root.add(ball("b"));

        List<RenderItem> items = items(root);

        assertThat(items.get(0).modelToWorld()).isEqualTo(new Matrix4f(outer).mul(inner));
        assertThat(items.get(1).modelToWorld()).isEqualTo(outer);
    }

    @Test
    void groupsTurnLightsButDoNotScaleThem() {
        TransformGroup root = new TransformGroup(
                new Matrix4f().translate(7, 8, 9).rotateZ((float) Math.PI / 2).scale(3));
        root.add(new LightNode(new Light(new Vector3f(4, 0, 0), new Vector3f(1, 2, 3))));

        Light light = scene(root).lights().next();

        // One rotation in float32.
        assertThat(light.towards().equals(new Vector3f(0, 1, 0), 1e-6f)).isTrue();
        assertThat(light.radiance()).isEqualTo(new Vector3f(1, 2, 3));
        assertThatThrownBy(() -> new Light(new Vector3f(), new Vector3f(1)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void aGroupCannotStandInsideItself() {
        Group outer = new Group();
        Group inner = new TransformGroup(new Matrix4f());
        outer.add(inner);

        assertThatThrownBy(() -> inner.add(outer)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> outer.add(outer)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void transformationsThatFlattenSpaceAreRefused() {
        assertThatThrownBy(() -> new TransformGroup(new Matrix4f().scale(1, 0, 1)))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new TransformGroup(new Matrix4f().perspective(1, 1, 1, 2)))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new TransformGroup(new Matrix4f().translate(Float.NaN, 0, 0)))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
