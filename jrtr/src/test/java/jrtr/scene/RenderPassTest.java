package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.Tile;
import jrtr.VertexData;
import jrtr.gl.FloatTarget;
import jrtr.gl.InARendering;
import jrtr.gl.ShaderProgram;
import jrtr.gl.VertexBuffer;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class RenderPassTest extends InARendering {
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

    private static List<RenderItem> items(VertexData data, boolean closed, Matrix4f place, float rotation) {
        VertexBuffer mesh = rendering.context.createVertexBuffer("mesh", data);
        Material material = new Material(Map.of(), Map.of()).turned(rotation);
        return new GraphSceneManager(new TransformGroup(place, new Shape(mesh, closed, material))).items();
    }

    private static List<RenderItem> items(VertexData data) {
        return items(data, false, new Matrix4f(), 0);
    }

    private float[] drawn(List<RenderItem> items, ShaderProgram program) {
        draw(items, program, target, Tile.whole(WIDTH, HEIGHT));
        return target.read(0);
    }

    private void draw(List<RenderItem> items, ShaderProgram program, FloatTarget whole, Tile tile) {
        View.Area area = View.Area.whole(whole.spec().width(), whole.spec().height());
        new RenderPass(rendering.context, program, Map.of(), true).draw(items, VIEW, area, whole, tile);
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
        float[] pixels = drawn(items(TestMeshes.sphere(256, 128)), program("vec4(normalize(worldNormal), 1)"));

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

    @Test
    void tilesGiveTheSamePictureAsOneDrawBitForBit() {
        List<RenderItem> sphere = items(TestMeshes.sphere(40, 20));
        ShaderProgram program = program(
                "vec4(viewDirection(tangentFrame()), 1) + vec4(surfaceCoordinate, 0, 0) * sin(worldPosition.x)");
        float[] atOnce = drawn(sphere, program);
        target.clear(Tile.whole(WIDTH, HEIGHT), 5, 5, 5, 5);

        for (Tile tile : Tile.whole(WIDTH, HEIGHT).divide(17)) {
            draw(sphere, program, target, tile);
        }

        assertThat(target.read(0)).isEqualTo(atOnce);
    }

    @Test
    void aMirroredBodyShowsItsFronts() {
        VertexData sphere = TestMeshes.sphere(40, 20);
        ShaderProgram depth = program("vec4(gl_FragCoord.zzz, 1)");
        float[] open = drawn(items(sphere), depth);

        assertThat(drawn(items(sphere, true, new Matrix4f(), 0), depth)).isEqualTo(open);
        float[] mirrored = drawn(items(sphere, true, new Matrix4f().scale(-1, 1, 1), 0), depth);
        // Depths are of order 0.75; mirrored triangles divide each cell along its other diagonal, 5e-3 of the radius
        // lower at most.
        assertThat(mirrored).usingComparatorWithPrecision(2e-2f).containsExactly(open);
    }

    @Test
    void anItemHidesThoseBehindItInAnyOrder() {
        ShaderProgram program = program("vec4(worldPosition, 1)");
        List<RenderItem> near = items(TestMeshes.square(), false, new Matrix4f().translation(0, 0, 0.25f), 0);
        List<RenderItem> far = items(TestMeshes.square());
        float[] expected = drawn(Stream.concat(near.stream(), far.stream()).toList(), program);

        assertThat(drawn(Stream.concat(far.stream(), near.stream()).toList(), program))
                .isEqualTo(expected);
        assertThat(expected[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2) + 2]).isEqualTo(0.25f);
    }

    @Test
    void copiedDepthSelectsTheCoveredPixels() {
        float[] shapes = drawn(items(TestMeshes.sphere(40, 20)), program("vec4(1)"));
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

    private static final int SIDE = 48;
    private static final int MIDDLE = 4 * (SIDE / 2 * SIDE + SIDE / 2);
    // A few operations in float32 on unit vectors.
    private static final float ROUNDING = 2e-6f;
    private static final String SHADER = """
            #include "jrtr/tangent_frame.glsl"
            layout(location = 0) out vec4 tangent;
            layout(location = 1) out vec4 bitangent;
            layout(location = 2) out vec4 normal;
            layout(location = 3) out vec4 light;
            layout(location = 4) out vec4 view;
            void main() {
                mat3 frame = tangentFrame();
                tangent = vec4(frame[0], 1.0);
                bitangent = vec4(frame[1], 1.0);
                normal = vec4(frame[2], 1.0);
                light = vec4(lightDirection(frame, 0), 1.0);
                view = vec4(viewDirection(frame), 1.0);
            }
            """;
    private final Camera camera = new Camera(new Vector3f(1, -3, 2), new Vector3f(0.2f, 0, 0), new Vector3f(0, 0, 1));
    private final Vector3f towardsLight = new Vector3f(0.6f, -0.48f, 0.64f);

    /** Draws a mesh and returns each image at the middle pixel. */
    private List<Vector3f> drawn(VertexData data, Matrix4f place, float rotation) {
        ShaderProgram program = rendering.meshProgram(SHADER);
        Light.apply(List.of(new Light(towardsLight, new Vector3f(1))), program);
        try (FloatTarget target =
                rendering.context.createFloatTarget("frames", new FloatTarget.Spec(SIDE, SIDE, 5, true))) {
            View view = new View(camera, 0.5f, 0, 0.5f, 20);
            new RenderPass(rendering.context, program, Map.of(), true)
                    .draw(
                            items(data, false, place, rotation),
                            view,
                            View.Area.whole(SIDE, SIDE),
                            target,
                            Tile.whole(SIDE, SIDE));
            return IntStream.range(0, 5)
                    .mapToObj(target::read)
                    .map(rgba -> new Vector3f(rgba[MIDDLE], rgba[MIDDLE + 1], rgba[MIDDLE + 2]))
                    .toList();
        }
    }

    private static VertexData mirrored(VertexData data) {
        float[] tangents = data.tangents().clone();
        for (int i = 3; i < tangents.length; i += 4) {
            tangents[i] = -1;
        }
        return new VertexData(data.positions(), data.normals(), tangents, data.textureCoordinates(), data.indices());
    }

    private static void assertClose(Vector3fc found, Vector3fc expected, float tolerance) {
        assertThat(found.distance(expected)).as("%s for %s", found, expected).isLessThan(tolerance);
    }

    @Test
    void lightAndViewAreInTheFrameOfAPlane() {
        List<Vector3f> images = drawn(TestMeshes.square(), new Matrix4f(), 0);

        assertClose(images.get(0), new Vector3f(1, 0, 0), ROUNDING);
        assertClose(images.get(1), new Vector3f(0, 1, 0), ROUNDING);
        assertClose(images.get(3), towardsLight, ROUNDING);
        Vector3f towardsEye = new Vector3f(camera.centerOfProjection())
                .sub(camera.lookAtPoint())
                .normalize();
        // The pixel's middle lies half a pixel, 0.5 / 48 / 2 rad, beside the line of sight.
        assertClose(images.get(4), towardsEye, 0.01f);
    }

    @Test
    void lightAndViewTurnAgainstTheSurface() {
        float angle = (float) Math.PI / 6;
        List<Vector3f> images = drawn(TestMeshes.square(), new Matrix4f().rotateX(angle), 0);

        Vector3f expected = new Vector3f(towardsLight).rotateX(-angle);
        assertClose(images.get(3), expected, ROUNDING);
    }

    @Test
    void thePatchTurnsCounterClockwiseSeenFromOutside() {
        float angle = (float) Math.toRadians(30);
        Vector3f turned = new Vector3f((float) Math.cos(angle), (float) Math.sin(angle), 0);

        List<Vector3f> right = drawn(TestMeshes.square(), new Matrix4f(), angle);
        List<Vector3f> left = drawn(mirrored(TestMeshes.square()), new Matrix4f(), angle);

        assertClose(right.get(0), turned, ROUNDING);
        assertClose(left.get(0), turned, ROUNDING);
        assertClose(right.get(1), new Vector3f(-turned.y, turned.x, 0), ROUNDING);
        assertClose(left.get(1), new Vector3f(turned.y, -turned.x, 0), ROUNDING);
    }

    @Test
    void unevenScalingKeepsNormalsOrthogonalToTheSurface() {
        // The plane z = x: normal (-1, 0, 1), flattened to z = x / 2, normal (-1, 0, 2).
        Matrix4f place = new Matrix4f().scale(1, 1, 0.5f).rotateY(-(float) Math.PI / 4);
        List<Vector3f> images = drawn(TestMeshes.square(), place, 0);

        assertClose(images.get(2), new Vector3f(-1, 0, 2).normalize(), ROUNDING);
        assertClose(images.get(0), new Vector3f(2, 0, 1).normalize(), ROUNDING);
    }

    /** Meshes with known analytic normals. */
    private static final class TestMeshes {
        private TestMeshes() {}

        /** The unit sphere: u to the east, v to the north, poles on z. */
        static VertexData sphere(int columns, int rows) {
            int vertices = (columns + 1) * (rows + 1);
            float[] positions = new float[3 * vertices];
            float[] tangents = new float[4 * vertices];
            float[] coordinates = new float[2 * vertices];
            for (int row = 0, i = 0; row <= rows; row++) {
                for (int column = 0; column <= columns; column++, i++) {
                    double polar = Math.PI * row / rows;
                    double turn = 2 * Math.PI * column / columns;
                    positions[3 * i] = (float) (Math.sin(polar) * Math.cos(turn));
                    positions[3 * i + 1] = (float) (Math.sin(polar) * Math.sin(turn));
                    positions[3 * i + 2] = (float) Math.cos(polar);
                    tangents[4 * i] = (float) -Math.sin(turn);
                    tangents[4 * i + 1] = (float) Math.cos(turn);
                    tangents[4 * i + 3] = 1;
                    coordinates[2 * i] = (float) column / columns;
                    coordinates[2 * i + 1] = 1 - (float) row / rows;
                }
            }
            // Two triangles from each upper left corner; rows go down, columns to the right.
            int[] indices = IntStream.range(0, columns * rows)
                    .map(face -> face + face / columns)
                    .flatMap(corner -> IntStream.of(0, columns + 1, columns + 2, 0, columns + 2, 1)
                            .map(further -> corner + further))
                    .toArray();
            return new VertexData(positions, positions.clone(), tangents, coordinates, indices);
        }

        /** The square from -1 to 1 in the plane z = 0, seen from above; u along x, v along y. */
        static VertexData square() {
            return new VertexData(
                    new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0},
                    new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                    new float[] {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1},
                    new float[] {0, 0, 1, 0, 1, 1, 0, 1},
                    new int[] {0, 1, 2, 0, 2, 3});
        }
    }
}
