package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import jrtr.Tile;
import jrtr.VertexData;
import jrtr.gl.FloatTarget;
import jrtr.gl.InARendering;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.scene.SceneGraph.Node;
import jrtr.scene.SceneGraph.Node.Group;
import jrtr.scene.SceneGraph.Node.Light;
import jrtr.scene.SceneGraph.Node.Shape;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class SceneGraphTest extends InARendering {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;
    private static final Camera CAMERA =
            new Camera(new Vector3f(0.5f, -4, 1.5f), new Vector3f(0, 0, 0.1f), new Vector3f(0, 0, 1));
    private static final View VIEW = new View(CAMERA, 0.7f, 1, 20);

    private static FloatTarget target;

    @BeforeAll
    static void createTarget() {
        target = rendering.context.createFloatTarget("picture", new FloatTarget.Spec(WIDTH, HEIGHT, 1, true));
    }

    private ShaderProgram program(String declarations, String color) {
        return rendering.meshProgram("#include \"jrtr/tangent_frame.glsl\"\n" + declarations
                + "\nlayout(location = 0) out vec4 color;\nvoid main() { color = " + color + "; }\n");
    }

    private Shape shape(VertexData data, ShaderProgram program) {
        return shape(data, program, Map.of());
    }

    private Shape shape(VertexData data, ShaderProgram program, Map<String, Float> uniforms) {
        return new Shape(rendering.context.createVertexBuffer("mesh", data), program, Map.of(), uniforms, Faces.BOTH);
    }

    private static SceneGraph scene(Node root) {
        return new SceneGraph(root, VIEW);
    }

    private static Node at(Matrix4f place, Shape shape) {
        return new Group(place, shape);
    }

    private float[] drawn(SceneGraph scene) {
        draw(scene, target, Tile.whole(WIDTH, HEIGHT));
        return target.read(0);
    }

    private void draw(SceneGraph scene, FloatTarget whole, Tile tile) {
        scene.draw(
                rendering.context,
                View.Area.whole(whole.spec().width(), whole.spec().height()),
                whole,
                tile);
    }

    /** Ray from the eye through the center of a pixel, computed from the camera's vectors without matrices. */
    private static Vector3f ray(int column, int row) {
        Vector3f forward = new Vector3f(CAMERA.lookAtPoint())
                .sub(CAMERA.centerOfProjection())
                .normalize();
        Vector3f right = new Vector3f(forward).cross(CAMERA.up()).normalize();
        Vector3f up = new Vector3f(right).cross(forward);
        float pixel = (float) (2 * Math.tan(VIEW.verticalFieldOfView() / 2) / HEIGHT);
        return forward.add(right.mul((column + 0.5f - WIDTH / 2f) * pixel))
                .add(up.mul((HEIGHT / 2f - row - 0.5f) * pixel));
    }

    @Test
    void aSpheresNormalsAreTheAnalyticOnes() {
        Shape sphere = shape(TestMeshes.sphere(256, 128), program("", "vec4(normalize(worldNormal), 1)"));
        float[] pixels = drawn(scene(sphere));

        int compared = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                Vector3f direction = ray(column, row).normalize();
                Vector3f eye = new Vector3f(CAMERA.centerOfProjection());
                float along = -eye.dot(direction);
                float missed = eye.lengthSquared() - along * along;
                int pixel = 4 * (row * WIDTH + column);
                if (missed > 1.01f) {
                    assertThat(pixels[pixel + 3]).isZero();
                } else if (missed < 0.9f) {
                    Vector3f normal =
                            direction.mul(along - (float) Math.sqrt(1 - missed)).add(eye);
                    Vector3f rendered = new Vector3f(pixels[pixel], pixels[pixel + 1], pixels[pixel + 2]);
                    // Facets of 0.025 rad lie up to 8e-5 below the sphere, seen at 18 degrees or steeper.
                    assertThat(rendered.distance(normal)).isLessThan(1e-3f);
                    assertThat(pixels[pixel + 3]).isEqualTo(1);
                    compared++;
                }
            }
        }
        assertThat(compared).isGreaterThan(500);
    }

    private Group crowd() {
        ShaderProgram program = program(
                "", "vec4(viewDirection(tangentFrame()), 1) + vec4(surfaceCoordinate, 0, 0) * sin(worldPosition.x)");
        Shape sphere = shape(TestMeshes.sphere(40, 20), program);
        Shape square = shape(TestMeshes.square(), program);
        return new Group(
                at(new Matrix4f().scale(3), square),
                at(new Matrix4f().translate(0.2f, 0, 0.4f).scale(0.6f), sphere),
                at(new Matrix4f().translate(-0.5f, -0.6f, 0.3f).rotateX(1).scale(0.3f, 0.4f, 0.5f), sphere),
                at(new Matrix4f().translate(-40, 0, 0), sphere));
    }

    @Test
    void tilesGiveTheSamePictureAsOneDrawBitForBit() {
        SceneGraph scene = scene(crowd());
        float[] atOnce = drawn(scene);
        target.clear(Tile.whole(WIDTH, HEIGHT), 5, 5, 5, 5);

        for (Tile tile : Tile.cover(WIDTH, HEIGHT, 17)) {
            draw(scene, target, tile);
        }

        assertThat(target.read(0)).isEqualTo(atOnce);
    }

    @Test
    void partsOfAPictureShowWhatTheWholeShows() {
        SceneGraph scene = scene(crowd());
        float[] whole = drawn(scene);
        Tile part = new Tile(33, 11, 40, 30);
        try (FloatTarget small = rendering.context.createFloatTarget("part", new FloatTarget.Spec(40, 30, 1, true))) {
            scene.draw(rendering.context, new View.Area(WIDTH, HEIGHT, part), small, Tile.whole(40, 30));
            float[] pixels = small.read(0);

            int different = 0;
            for (int row = 0; row < 30; row++) {
                for (int i = 0; i < 4 * 40; i++) {
                    float expected = whole[4 * ((row + 11) * WIDTH + 33) + i];
                    // Both matrices round differently, by some 1e-6.
                    different += Math.abs(pixels[4 * 40 * row + i] - expected) > 1e-4f ? 1 : 0;
                }
            }
            // Only pixels that an edge just touches may belong to another shape.
            assertThat(different).isLessThan(4 * 20);
            assertThatThrownBy(() -> draw(scene, small, new Tile(30, 0, 20, 5)))
                    .isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> scene.draw(rendering.context, View.Area.whole(41, 30), small, Tile.whole(40, 30)))
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void lightsAndUniformsAreThoseOfTheScene() {
        ShaderProgram program = program(
                "uniform float strength;",
                "vec4(strength * max(0.0, lightDirection(tangentFrame(), 0).z) * lightRadiances[0], 1)");
        int middle = 4 * (HEIGHT / 2 * WIDTH + WIDTH / 2);

        float[] first = drawn(lit(program, 2, new Matrix4f()));
        float[] second = drawn(lit(program, 8, new Matrix4f().rotateX((float) Math.PI / 3)));

        // Lambert: cos 0 = 1, then cos 60 = 1/2; float32 rounding.
        assertThat(first[middle]).isCloseTo(2, within(1e-5f));
        assertThat(first[middle + 1]).isCloseTo(1, within(1e-5f));
        assertThat(second[middle]).isCloseTo(4, within(1e-5f));
    }

    private SceneGraph lit(ShaderProgram program, float strength, Matrix4f place) {
        Group root = new Group(
                new Group(place, new Light(new Vector3f(0, 0, 2), new Vector3f(1, 0.5f, 0))),
                shape(TestMeshes.square(), program, Map.of("strength", strength)));
        return scene(root);
    }

    @Test
    void nearerShapesHideFartherOnesInAnyOrder() {
        Shape large = shape(TestMeshes.square(), program("", "vec4(1)"));
        Shape front = shape(TestMeshes.square(), program("", "vec4(2)"));
        Shape back = shape(TestMeshes.square(), program("", "vec4(3)"));
        // The large square's bounding sphere comes nearest, so that it is drawn first.
        Group root = new Group(
                at(new Matrix4f().translate(0, 0, 0.2f).scale(0.1f), front),
                at(new Matrix4f().scale(1.5f), large),
                at(new Matrix4f().translate(0, 0, -0.2f).scale(0.3f), back));

        float[] pixels = drawn(scene(root));

        assertThat(pixels).contains(1, 2).doesNotContain(3);
    }

    @Test
    void copiedDepthSelectsTheCoveredPixels() {
        float[] shapes = drawn(scene(shape(TestMeshes.sphere(40, 20), program("", "vec4(1)"))));
        ShaderProgram two = rendering.program("", "vec4(2)");
        Tile whole = Tile.whole(WIDTH, HEIGHT);
        try (FloatTarget other = rendering.context.createFloatTarget("other", target.spec());
                FloatTarget flat = rendering.context.createFloatTarget("flat", FloatTarget.Spec.color(WIDTH, HEIGHT))) {
            other.clear(whole, 0, 0, 0, 0);
            other.copyDepthFrom(target);
            rendering.context.drawCovered(two, Map.of(), other, whole);
            // The draw keeps the depth.
            rendering.context.drawCovered(two, Map.of(), other, whole);

            float[] covered = other.read(0);
            assertThat(shapes).contains(0, 1);
            for (int i = 0; i < shapes.length; i++) {
                assertThat(covered[i]).isEqualTo(2 * shapes[i]);
            }
            assertThatThrownBy(() -> rendering.context.drawCovered(two, Map.of(), flat, whole))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("'flat' has no depth");
        }
    }

    private Shape ball(String label) {
        ShaderProgram program = program("", "vec4(1)");
        return new Shape(
                rendering.context.createVertexBuffer(label, TestMeshes.sphere(4, 4)),
                program,
                Map.of(),
                Map.of(),
                Faces.BOTH);
    }

    @Test
    void shapesComeDepthFirstInTheirOrderWithTransformationsFromTheTopDown() {
        Matrix4f outer = new Matrix4f().translate(1, 2, 3);
        Matrix4f inner = new Matrix4f().rotateZ(0.5f).scale(2);
        Group second = new Group(inner, ball("c"));
        Group root = new Group(outer, ball("a"), new Group(ball("b"), second), new Group(), second, ball("d"));

        List<SceneGraph.ShapeInstance> shapes = scene(root).shapes();
        assertThat(shapes.stream().map(item -> item.shape().vertices().label()))
                .containsExactly("a", "b", "c", "c", "d");
        assertThat(shapes.get(2).modelToWorld()).isEqualTo(new Matrix4f(outer).mul(inner));
        assertThat(shapes.get(4).modelToWorld()).isEqualTo(outer);
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
    }

    @Test
    void transformationsThatFlattenSpaceAndLightsWithoutDirectionAreRefused() {
        for (Matrix4f flat : List.of(
                new Matrix4f().scale(1, 0, 1),
                new Matrix4f().perspective(1, 1, 1, 2),
                new Matrix4f().translate(Float.NaN, 0, 0))) {
            assertThatThrownBy(() -> new Group(flat)).isInstanceOf(IllegalArgumentException.class);
        }
        assertThatThrownBy(() -> new Light(new Vector3f(), new Vector3f(1)))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
