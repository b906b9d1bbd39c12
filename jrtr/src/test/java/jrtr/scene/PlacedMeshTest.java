package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import jrtr.Tile;
import jrtr.VertexData;
import jrtr.gl.FloatTarget;
import jrtr.gl.InARendering;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class PlacedMeshTest extends InARendering {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 60;
    private static final Camera CAMERA =
            new Camera(new Vector3f(0.5f, -4, 1.5f), new Vector3f(0, 0, 0.1f), new Vector3f(0, 0, 1));
    private static final View VIEW = new View(CAMERA, 0.7f, 0, 1, 20);

    private static FloatTarget target;

    @BeforeAll
    static void createTarget() {
        target = rendering.context.createFloatTarget("picture", new FloatTarget.Spec(WIDTH, HEIGHT, 1, true));
    }

    private ShaderProgram program(String color) {
        return rendering.meshProgram("#include \"jrtr/tangent_frame.glsl\"\n"
                + "layout(location = 0) out vec4 color;\nvoid main() { color = " + color + "; }\n");
    }

    private PlacedMesh placed(VertexData data, ShaderProgram program) {
        return new PlacedMesh(
                rendering.context.createVertexBuffer("mesh", data), new Matrix4f(), program, Map.of(), Faces.BOTH);
    }

    private float[] drawn(PlacedMesh mesh) {
        draw(mesh, target, Tile.whole(WIDTH, HEIGHT));
        return target.read(0);
    }

    private void draw(PlacedMesh mesh, FloatTarget whole, Tile tile) {
        View.Area area = View.Area.whole(whole.spec().width(), whole.spec().height());
        mesh.draw(rendering.context, VIEW, area, whole, tile);
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
        float[] pixels = drawn(placed(TestMeshes.sphere(256, 128), program("vec4(normalize(worldNormal), 1)")));

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

    private PlacedMesh sphere() {
        return placed(
                TestMeshes.sphere(40, 20),
                program(
                        "vec4(viewDirection(tangentFrame()), 1) + vec4(surfaceCoordinate, 0, 0) * sin(worldPosition.x)"));
    }

    @Test
    void tilesGiveTheSamePictureAsOneDrawBitForBit() {
        PlacedMesh sphere = sphere();
        float[] atOnce = drawn(sphere);
        target.clear(Tile.whole(WIDTH, HEIGHT), 5, 5, 5, 5);

        for (Tile tile : Tile.whole(WIDTH, HEIGHT).divide(17)) {
            draw(sphere, target, tile);
        }

        assertThat(target.read(0)).isEqualTo(atOnce);
    }

    @Test
    void copiedDepthSelectsTheCoveredPixels() {
        float[] shapes = drawn(placed(TestMeshes.sphere(40, 20), program("vec4(1)")));
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
}
