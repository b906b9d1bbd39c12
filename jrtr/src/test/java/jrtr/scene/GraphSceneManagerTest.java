package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import jrtr.VertexData;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.InARendering;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.junit.jupiter.api.Test;

class GraphSceneManagerTest extends InARendering {
    // A few operations in float32 on coordinates of order 10.
    private static final float ROUNDING = 1e-5f;
    private static final float[] CORNERS = {1, 0, 0, 0, 2, 0, 0, 0, 3};

    /** A triangle. */
    private static Shape shape() {
        VertexData data = new VertexData(CORNERS, new float[9], new float[12], new float[6], new int[] {0, 1, 2});
        return new Shape(
                rendering.context.createVertexBuffer("triangle", data), false, new Material(Map.of(), Map.of()));
    }

    private static TransformGroup moved(float x, float y, float z, Node... children) {
        return new TransformGroup(new Matrix4f().translation(x, y, z), children);
    }

    private static Vector3f transformed(RenderItem item) {
        return item.modelToWorld().transformPosition(new Vector3f(1, 0, 0));
    }

    @Test
    void transformsOfParentsApplyAfterThoseOfChildren() {
        Node turned = new TransformGroup(new Matrix4f().rotationZ((float) Math.PI / 2), moved(1, 0, 0, shape()));
        GraphSceneManager graph = new GraphSceneManager(moved(0, 0, 5, turned, shape()));

        assertThat(transformed(graph.items().get(0)).distance(0, 2, 5)).isLessThan(ROUNDING);
        assertThat(transformed(graph.items().get(1)).distance(1, 0, 5)).isLessThan(ROUNDING);
    }

    @Test
    void aNodeInTwoGroupsIsDrawnTwice() {
        TransformGroup wheel = moved(0, 1, 0, shape());
        GraphSceneManager graph = new GraphSceneManager(moved(0, 0, 0, moved(1, 0, 0, wheel), moved(2, 0, 0, wheel)));

        assertThat(graph.items()).extracting(item -> transformed(item).x).containsExactly(2f, 3f);
        assertThat(graph.items().get(0).shape()).isSameAs(graph.items().get(1).shape());
        assertThat(graph.toWorld(wheel).getTranslation(new Vector3f())).isEqualTo(new Vector3f(2, 1, 0));
    }

    @Test
    void lightsAndCamerasFollowTheirGroups() {
        Camera camera = new Camera(new Vector3f(0, -5, 0), new Vector3f(), new Vector3f(0, 0, 1));
        Light light = new Light(new Vector3f(1, 0, 0), new Vector3f(2, 3, 4));
        Matrix4f turn = new Matrix4f().translation(0, 0, 7).rotateZ((float) Math.PI / 2);
        GraphSceneManager graph = new GraphSceneManager(new TransformGroup(turn, light, camera));

        assertThat(graph.lights().get(0).towards().distance(0, 1, 0)).isLessThan(ROUNDING);
        assertThat(graph.lights().get(0).radiance()).isEqualTo(light.radiance());
        assertThat(graph.camera().orElseThrow().centerOfProjection().distance(5, 0, 7))
                .isLessThan(ROUNDING);
        assertThat(graph.camera().orElseThrow().lookAtPoint().distance(0, 0, 7)).isLessThan(ROUNDING);
        assertThat(graph.bounds()).as("no shapes").isEmpty();
        assertThatThrownBy(() -> new GraphSceneManager(moved(0, 0, 0, camera, moved(1, 0, 0, camera))))
                .hasMessageContaining("2 cameras");
    }

    /** No group contains itself: it takes a copy of its list of children. */
    @Test
    void aGroupPutIntoItsOwnListIsNotItsChild() {
        List<Node> children = new ArrayList<>(List.of(shape()));
        TransformGroup group = new TransformGroup(new Matrix4f(), children);
        children.add(group);

        assertThat(group.children()).hasSize(1);
        assertThat(new GraphSceneManager(group).items()).hasSize(1);
    }

    @Test
    void transformsThatFlattenOrAreNotAffineAreRefused() {
        Matrix4f projection = new Matrix4f().perspective(1, 1, 0.1f, 10);
        for (Matrix4f wrong : List.of(new Matrix4f().scaling(1, 0, 1), projection, new Matrix4f().m30(Float.NaN))) {
            assertThatThrownBy(() -> new TransformGroup(wrong, List.of()))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("affine");
        }
        GraphSceneManager graph = new GraphSceneManager(shape());
        assertThatThrownBy(() -> graph.toWorld(moved(1, 0, 0))).hasMessageContaining("not in this scene graph");
    }

    @Test
    void theBoundsContainAllVertices() {
        Random random = new Random(5);
        for (int trial = 0; trial < 50; trial++) {
            List<Node> parts = new ArrayList<>();
            for (int part = 0; part < 4; part++) {
                Matrix4f place = new Matrix4f()
                        .translation(10 * random.nextFloat(), random.nextFloat(), random.nextFloat())
                        .rotate(new Quaternionf().rotationXYZ(random.nextFloat(), random.nextFloat(), 0))
                        .scale(random.nextFloat() + 0.1f, random.nextFloat() + 0.1f, 2)
                        .rotateX(random.nextFloat());
                parts.add(new TransformGroup(place, shape()));
            }
            GraphSceneManager graph = new GraphSceneManager(new TransformGroup(new Matrix4f().rotationY(1), parts));
            BoundingSphere bounds = graph.bounds().orElseThrow();
            for (RenderItem item : graph.items()) {
                for (int i = 0; i < 9; i += 3) {
                    Vector3f vertex = new Vector3f(CORNERS[i], CORNERS[i + 1], CORNERS[i + 2]);
                    Vector3fc world = item.modelToWorld().transformPosition(vertex);
                    assertThat(world.distance(bounds.center())).isLessThan(bounds.radius() + ROUNDING);
                }
            }
        }
    }

    /** To rounding, so that a turned scene has the planes and shadows of the unturned one. */
    @Test
    void aRotationAboutTheCenterKeepsTheBounds() {
        BoundingSphere bounds = shape().mesh().bounds();
        Vector3f center = new Vector3f(bounds.center());
        Node inner = moved(-center.x, -center.y, -center.z, shape());
        Node turn = new TransformGroup(new Matrix4f().rotation(new Quaternionf().rotationXYZ(0.3f, 1, 2)), inner);
        GraphSceneManager graph = new GraphSceneManager(moved(center.x, center.y, center.z, turn));

        BoundingSphere turned = graph.bounds().orElseThrow();
        assertThat(turned.center().distance(bounds.center())).isLessThan(ROUNDING);
        assertThat(turned.radius()).isEqualTo(bounds.radius());
        Matrix4f halved = new Matrix4f().rotationX(1).scale(0.5f);
        assertThat(bounds.transformed(halved).radius()).isCloseTo(bounds.radius() / 2, within(ROUNDING));
    }

    @Test
    void theSphereAroundTwoJustHoldsBoth() {
        BoundingSphere left = new BoundingSphere(new Vector3f(-3, 0, 0), 1);
        BoundingSphere right = new BoundingSphere(new Vector3f(3, 0, 0), 2);
        BoundingSphere both = left.with(right);

        assertThat(both.radius()).isEqualTo(4.5f);
        assertThat(both.center().distance(0.5f, 0, 0)).isLessThan(ROUNDING);
        assertThat(both.with(right)).as("an inner one").isEqualTo(both);
        assertThat(right.with(both)).isEqualTo(both);
    }
}
