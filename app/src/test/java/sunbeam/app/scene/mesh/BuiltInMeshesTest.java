package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.ScaleRelief;
import sunbeam.app.scene.texture.Scales;

/** Built-in meshes, the snake among them, the sky that a body leaves visible, and files of meshes with their maps. */
class BuiltInMeshesTest {
    /** A facet tilts against the normals of its corners by half of its bend; most at a disc's edge, and at the point of the snake's snout. */
    @ParameterizedTest
    @CsvSource({"plane, 0.001", "sphere, 6", "ellipsoid, 9", "cylinder, 4", "disc, 30", "snake, 79"})
    void framesAreOrthonormalAndNormalsFaceOutwards(String name, double facetDegrees) {
        Mesh mesh = BuiltInMeshes.create(name);

        MeshChecks.assertOrthonormalFrames(mesh);
        MeshChecks.assertNormalsFaceOutwards(mesh, Math.cos(Math.toRadians(facetDegrees)));
    }

    @Test
    void aPlanesFrameIsThatOfTheWorldAndACylindersMantleStandsOnTheGround() {
        Mesh plane = BuiltInMeshes.plane(2, 3);
        Mesh cylinder = BuiltInMeshes.cylinder(0.1, 0.2, 48, 4);

        MeshChecks.assertTangentsFollowTheTexture(plane, 1 - 1e-6);
        assertThat(MeshChecks.area(plane)).isCloseTo(4, within(1e-6));
        assertThat(plane.tangents()).startsWith(1, 0, 0, 1);
        assertThat(plane.normals()).startsWith(0, 0, 1);
        MeshChecks.assertTangentsFollowTheTexture(cylinder, Math.cos(Math.toRadians(4)));
        assertThat(cylinder.toVertexData().bounds().center().z()).isCloseTo(0.1f, within(1e-6f));
    }

    @Test
    void aDiscLiesOnTheGroundAndItsTangentsFollowItsTracks() {
        Mesh disc = BuiltInMeshes.create("disc");

        double largest = 0;
        for (int vertex = 0; vertex < disc.vertices(); vertex++) {
            Vector3d position = MeshChecks.position(disc, vertex);
            assertThat(position.z).isBetween(-1e-6, 0.0012 + 1e-6);
            double radius = Math.hypot(position.x, position.y);
            largest = Math.max(largest, radius);
            // A track is a circle about the axis: no part of the tangent points away from it. Float32.
            assertThat(MeshChecks.tangent(disc, vertex).dot(new Vector3d(position.x, position.y, 0)))
                    .isCloseTo(0, within(1e-6 * radius));
        }
        assertThat(largest).isCloseTo(0.059, within(1e-6));
        double[] radii = IntStream.range(0, disc.vertices())
                .mapToObj(vertex -> MeshChecks.position(disc, vertex))
                .mapToDouble(position -> Math.hypot(position.x, position.y))
                .toArray();
        // The hole of 15 mm, and no tracks below 46 mm: there only the stacking ring. Float32.
        assertThat(Arrays.stream(radii).min()).hasValueCloseTo(0.0075, within(1e-6));
        assertThat(Arrays.stream(radii).filter(radius -> radius > 0.0182).min()).hasValueCloseTo(0.023, within(1e-6));
        for (int i = 0; i < disc.indices().length; i += 3) {
            double[] corners = IntStream.range(i, i + 3)
                    .mapToDouble(corner -> radii[disc.indices()[corner]])
                    .toArray();
            assertThat(Arrays.stream(corners).min().orElseThrow() < 0.0182)
                    .as("a triangle of the hub ends there")
                    .isEqualTo(Arrays.stream(corners).max().orElseThrow() < 0.0182);
        }
    }

    private static final Mesh SNAKE = BuiltInMeshes.create("snake");

    @Test
    void itsSkinIsClosed() {
        MeshChecks.assertClosed(SNAKE);
    }

    @Test
    void itLiesOnTheGround() {
        // A tenth of a millimeter: less than a pixel of any picture of the whole snake.
        assertThat(SkyVisibility.ground(SNAKE)).isBetween(-1e-4, 1e-4);
        assertThat(SnakeBody.length()).isBetween(1.0, 1.2);
    }

    /** Scales are {@link ScaleRelief#LENGTH} widths of a row long wherever the body is thick. */
    @ParameterizedTest
    @CsvSource({"SMOOTH", "KEELED"})
    void scalesKeepTheirShapeAlongTheBody(Scales scales) {
        for (double place : new double[] {0.1, 0.3, 0.5, 0.7}) {
            double step = 0.01;
            double units = SnakeBody.u(place + step) - SnakeBody.u(place - step);
            double length = 2 * step * SnakeBody.length() / (units * scales.perUnit());
            // The girth of the elliptic cross-section is about 5.8 half widths.
            double row = 5.8 * SnakeBody.halfWidth(place) * ScaleRelief.DORSAL / scales.rows();
            // The girth is rounded.
            assertThat(length / row).as("at %s", place).isCloseTo(ScaleRelief.LENGTH, within(0.06));
        }
    }

    private static final double RADIUS = 0.1;
    private static final Mesh SPHERE = BuiltInMeshes.sphere(RADIUS, 96, 48);
    private static final SkyVisibility SKY = SkyVisibility.of(SPHERE, BlobCache.NONE);

    private static float ground(double x) {
        int side = SkyVisibility.GROUND_SIDE;
        int column = (int) (side * (0.5 + x / (2 * SkyVisibility.GROUND_REACH * RADIUS)));
        return SKY.ofGround()[side / 2 * side + column];
    }

    /** A sphere's form factor: (R / D)^2 times the cosine of its direction, R / D, at the distance D from its middle. */
    @Test
    void aSphereHidesAsMuchOfTheSkyAsItsFormFactor() {
        // A map of 64 directions and squares of 2 mm.
        for (double x : new double[] {-0.15, -0.1, 0.1, 0.15}) {
            double distance = Math.hypot(x, RADIUS);
            assertThat(ground(x)).as("at %s", x).isCloseTo((float) (1 - Math.pow(RADIUS / distance, 3)), within(0.05f));
        }
        assertThat(ground(0)).isLessThan(0.05f);
    }

    /** A convex body hides no sky from itself above its tangent planes. */
    @Test
    void aSphereHidesNothingOfItself() {
        for (int i = 0; i < SPHERE.vertices(); i++) {
            if (SPHERE.normals()[3 * i + 2] > -0.5f) {
                assertThat(SKY.ofVertices()[i]).as("vertex %s", i).isGreaterThan(0.98f);
            }
        }
    }

    @TempDir
    private Path folder;

    /** Only glTF has tangents; others are facets', worst where a facet bends most, at the snake's snout and eyes. */
    @ParameterizedTest
    @CsvSource({"obj, 0.7", "ply, 0.7", "glb, 0.999999"})
    void theSnakeComesBack(String ending, double leastCosine) throws IOException {
        Path file = folder.resolve("snake." + ending);
        try (OutputStream stream = Files.newOutputStream(file)) {
            switch (ending) {
                case "obj" -> MeshWriters.obj(stream, SNAKE);
                case "ply" -> MeshWriters.ply(stream, SNAKE);
                default -> MeshWriters.glb(stream, SNAKE, Optional.empty());
            }
        }
        MeshSource.Loaded read = MeshSource.of(file.toString()).load();
        assertThat(read.warnings()).isEmpty();
        assertThat(read.mesh().triangles()).isEqualTo(SNAKE.triangles());
        double moved = 0;
        double worst = 0;
        double cosine = 1;
        for (int i = 0; i < SNAKE.indices().length; i++) {
            int from = SNAKE.indices()[i];
            int to = read.mesh().indices()[i];
            moved = Math.max(moved, MeshChecks.position(read.mesh(), to).distance(MeshChecks.position(SNAKE, from)));
            worst = Math.max(worst, MeshChecks.normal(read.mesh(), to).distance(MeshChecks.normal(SNAKE, from)));
            worst = Math.max(
                    worst,
                    Math.abs(read.mesh().textureCoordinates()[2 * to + 1] - SNAKE.textureCoordinates()[2 * from + 1]));
            cosine = Math.min(cosine, MeshChecks.tangent(read.mesh(), to).dot(MeshChecks.tangent(SNAKE, from)));
            assertThat(read.mesh().tangents()[4 * to + 3]).isEqualTo(1);
        }
        assertThat(moved).isZero();
        assertThat(cosine).isGreaterThan(leastCosine);
        assertThat(worst).as("normalized again; 1 - (1 - v) in float32").isLessThan(MeshChecks.ROUNDING);
    }

    @Test
    void normalMapsLeanAgainstTheSlopesOfTheScales() {
        BodyTexture gray = new BodyTexture(1, 1, new byte[] {100, 100, 100, -1});
        SkinMaps maps = SkinMaps.of(body(gray, Scales.KEELED), 2048, 64);
        BufferedImage normals = maps.normals().orElseThrow();
        int[] red = new int[normals.getWidth() / 2];
        double steepest = 0;
        double worst = 0;
        for (int i = 0; i < red.length; i++) {
            // The middle of the back.
            int rgb = normals.getRGB(normals.getWidth() / 3 + i, normals.getHeight() / 2);
            red[i] = rgb >> 16 & 255;
            Vector3d normal =
                    new Vector3d(red[i], rgb >> 8 & 255, rgb & 255).div(127.5).sub(1, 1, 1);
            worst = Math.max(worst, Math.abs(normal.length() - 1));
            steepest = Math.max(steepest, Math.hypot(normal.x, normal.y) / normal.z);
        }
        Arrays.sort(red);

        // Half a step of 8 bits in each of three numbers.
        assertThat(worst).isLessThan(1.5 / 127.5);
        // Either slope is at most STEEPEST; 8 bits.
        assertThat(steepest).isLessThan(Math.sqrt(2) * ScaleRelief.STEEPEST + 0.02);
        // Scales rise towards the tail, which is +u: by a tenth, their tilt over their length. Normals lean to the
        // head.
        assertThat(red[red.length / 2] / 127.5 - 1).isBetween(-0.15, -0.05);
        // On the head there are none: the middle of the frontal shield leans by a few degrees, and a groove surrounds
        // it.
        assertThat(slope(normals, 65)).isLessThan(0.08);
        assertThat(IntStream.range(65, 90)
                        .mapToDouble(column -> slope(normals, column))
                        .max()
                        .orElseThrow())
                .isBetween(0.1, ScaleRelief.STEEPEST);
        assertThat(maps.albedo().getRGB(65, 32) & 0xffffff).isEqualTo(0x646464);
    }

    @Test
    void onlyASmoothSnakesLowestScalesAndTheRimsAboveThemArePale() {
        BodyTexture black = new BodyTexture(1, 1, new byte[] {0, 0, 0, -1});
        for (Scales scales : new Scales[] {Scales.SMOOTH, Scales.KEELED}) {
            BufferedImage albedo = SkinMaps.of(body(black, scales), 2048, 64).albedo();
            // The lowest of 15 rows is centered 7 of 15 times 0.76 of the girth away from the back.
            int lowest = (int) (64 * (0.5 + 0.76 * 7 / 15));
            double[] reds = IntStream.of(32, lowest)
                    .mapToDouble(row -> IntStream.range(1000, 1100)
                            .map(column -> albedo.getRGB(column, row) >> 16 & 255)
                            .average()
                            .orElseThrow())
                    .toArray();
            assertThat(reds[0]).as("back of %s", scales).isZero();
            assertThat(reds[1]).as("lowest row of %s", scales).isBetween(scales == Scales.SMOOTH ? 100.0 : 0, 255.0);
            assertThat(reds[1] > 0).isEqualTo(scales == Scales.SMOOTH);
        }
    }

    /** Magnitude of the slope in a column of the middle of the back. */
    private static double slope(BufferedImage normals, int column) {
        int rgb = normals.getRGB(column, normals.getHeight() / 2);
        return Math.hypot((rgb >> 16 & 255) / 127.5 - 1, (rgb >> 8 & 255) / 127.5 - 1);
    }

    @Test
    void smoothSkinHasItsTextureAlone() {
        BodyTexture texture = new BodyTexture(2, 1, new byte[] {1, 2, 3, -1, 4, 5, 6, -1});

        SkinMaps maps = SkinMaps.of(body(texture, Scales.NONE));

        assertThat(maps.normals()).isEmpty();
        assertThat(maps.albedo().getRGB(0, 0) & 0xffffff).isEqualTo(0x010203);
        assertThat(maps.albedo().getRGB(1, 0) & 0xffffff).isEqualTo(0x040506);
    }

    private static Body body(BodyTexture colors, Scales scales) {
        return new Body(colors, scales, ScaleRelief.of(scales, BlobCache.NONE), colors, colors);
    }
}
