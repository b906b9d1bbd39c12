package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.app.files.cache.BlobCache;

class SkyVisibilityTest {
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
