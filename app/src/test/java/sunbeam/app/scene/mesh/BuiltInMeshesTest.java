package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.files.cache.BlobCache;

/** Built-in meshes, the snake among them, and the sky that a body leaves visible. */
class BuiltInMeshesTest {
    /** A facet tilts against the normals of its corners by half of its bend; most at a disc's edge, and at the point of the snake's snout. */
    @ParameterizedTest
    @CsvSource({"plane, 0.001", "sphere, 6", "cylinder, 4", "disc, 30", "snake, 79"})
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

    @Test
    void noPartOfTheBodyRunsThroughAnother() {
        int sections = 400;
        for (int i = 0; i <= sections; i++) {
            double place = (double) i / sections;
            Vector3d center = SnakeBody.center(place);
            Vector3d forward = SnakeBody.direction(place);
            Vector3d right = new Vector3d(forward).cross(0, 0, 1).normalize();
            Vector3d up = right.cross(forward, new Vector3d());
            for (int vertex = 0; vertex < SNAKE.vertices(); vertex += 3) {
                double other = SNAKE.textureCoordinates()[2 * vertex];
                Vector3d relative = MeshChecks.position(SNAKE, vertex).sub(center);
                // The neighborhood along the body always touches; a coil's inner side is 0.1 of the body long.
                if (Math.abs(other - SnakeBody.u(place)) > 0.08
                        && Math.abs(relative.dot(forward)) < SnakeBody.length() / sections) {
                    double x = relative.dot(right) / SnakeBody.halfWidth(place);
                    double height = relative.dot(up);
                    double y = height / (height > 0 ? SnakeBody.halfHeight(place) : SnakeBody.bellyDepth(place));
                    // 1 is touching; coils press each other by a few percent, half a millimeter.
                    assertThat(x * x + y * y)
                            .as("skin at %s inside the body at %s", other, place)
                            .isGreaterThan(0.95 * 0.95);
                }
            }
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
}
