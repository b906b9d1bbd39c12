package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import jrtr.Faces;
import jrtr.gl.NeedsDisplay;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.glsl.ShaderTexts;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

@NeedsDisplay
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class GraphTest {
    private static final Camera CAMERA = new Camera(new Vector3f(0, -5, 0), new Vector3f(), new Vector3f(0, 0, 1));
    private static final Frustum FRUSTUM = new Frustum(1, 0.1f, 100);

    private RenderContext context;
    private ShaderProgram program;

    private static SceneGraph scene(Node root) {
        return new SceneGraph(root, CAMERA, FRUSTUM);
    }

    private static List<SceneGraph.ShapeInstance> items(Node root) {
        return scene(root).shapes();
    }

    private static String label(SceneGraph.ShapeInstance item) {
        return item.shape().vertices().label();
    }

    @BeforeAll
    void open() {
        context = RenderContext.offscreen();
        String text = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1); }\n";
        program = context.createMeshProgram(
                ShaderTexts.of(Map.of("test.frag", text)).load("test.frag"));
    }

    @AfterAll
    void close() {
        context.close();
    }

    private Shape ball(String label) {
        return new Shape(
                context.createVertexBuffer(label, TestMeshes.sphere(4, 4)),
                new Material(program, Map.of(), Map.of(), Faces.BOTH));
    }

    @Test
    void shapesComeDepthFirstInTheirOrder() {
        Group second = new Group(ball("c"), ball("d"));
        Group root = new Group(ball("a"), new Group(ball("b"), second), new Group(), second, ball("f"));

        assertThat(items(root).stream().map(GraphTest::label)).containsExactly("a", "b", "c", "d", "c", "d", "f");
        assertThat(items(new Group())).isEmpty();
        assertThat(items(ball("alone"))).hasSize(1);
    }

    @Test
    void transformationsMultiplyFromTheTopDown() {
        Matrix4f outer = new Matrix4f().translate(1, 2, 3);
        Matrix4f inner = new Matrix4f().rotateZ(0.5f).scale(2);

        List<SceneGraph.ShapeInstance> items = items(new Group(outer, new Group(inner, ball("a")), ball("b")));

        assertThat(items.get(0).modelToWorld()).isEqualTo(new Matrix4f(outer).mul(inner));
        assertThat(items.get(1).modelToWorld()).isEqualTo(outer);
    }

    @Test
    void groupsTurnLightsButDoNotScaleThem() {
        Group root = new Group(
                new Matrix4f().translate(7, 8, 9).rotateZ((float) Math.PI / 2).scale(3),
                new Light(new Vector3f(4, 0, 0), new Vector3f(1, 2, 3)));

        Light light = scene(root).lights().get(0);

        // One rotation in float32.
        assertThat(light.towards().equals(new Vector3f(0, 1, 0), 1e-6f)).isTrue();
        assertThat(light.radiance()).isEqualTo(new Vector3f(1, 2, 3));
        assertThatThrownBy(() -> new Light(new Vector3f(), new Vector3f(1)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void transformationsThatFlattenSpaceAreRefused() {
        assertThatThrownBy(() -> new Group(new Matrix4f().scale(1, 0, 1))).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Group(new Matrix4f().perspective(1, 1, 1, 2)))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Group(new Matrix4f().translate(Float.NaN, 0, 0)))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
