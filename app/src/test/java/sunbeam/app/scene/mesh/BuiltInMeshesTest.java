package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.files.InputException;

class BuiltInMeshesTest {
    /** A facet tilts against the normals of its corners by half of its bend; most at a disc's edge, and at the point of the snake's snout. */
    @ParameterizedTest
    @CsvSource({"plane, 0.001", "sphere, 6", "cylinder, 4", "disc, 30", "snake, 79"})
    void framesAreOrthonormalAndNormalsFaceOutwards(String name, double facetDegrees) {
        Mesh mesh = BuiltInMeshes.create(name);

        MeshChecks.assertNoDegenerateTriangle(mesh);
        MeshChecks.assertOrthonormalFrames(mesh);
        MeshChecks.assertNormalsFaceOutwards(mesh, Math.cos(Math.toRadians(facetDegrees)));
    }

    @Test
    void aPlaneIsFlatAndItsFrameIsThatOfTheWorld() {
        Mesh plane = BuiltInMeshes.plane(2, 3);

        MeshChecks.assertTangentsFollowTheTexture(plane, 1 - 1e-6);
        assertThat(MeshChecks.area(plane)).isCloseTo(4, within(1e-6));
        assertThat(plane.tangents()).startsWith(1, 0, 0, 1);
        assertThat(plane.normals()).startsWith(0, 0, 1);
    }

    @Test
    void aCylindersMantleStandsOnTheGround() {
        Mesh cylinder = BuiltInMeshes.cylinder(0.1, 0.2, 48, 4);

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

    @Test
    void builtInMeshesHaveNames() {
        assertThatThrownBy(() -> BuiltInMeshes.create("torus"))
                .isInstanceOf(InputException.class)
                .hasMessage("there is no built-in mesh \"torus\"; choose one of snake, plane, sphere, cylinder, disc");
    }
}
