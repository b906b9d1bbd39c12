package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.Map;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class SnakeMeshTest {
    private static final Mesh SNAKE = SnakeMesh.create();
    private static final SnakeSurface SURFACE = new SnakeSurface();

    @Test
    void itIsAsLargeAsTheThesissScan() {
        // About 11,700 vertices and 23,000 triangles: within 1 % and 2 %.
        assertThat(SNAKE.vertices()).isBetween(11_600, 11_800);
        assertThat(SNAKE.triangles()).isBetween(22_500, 23_500);
    }

    @Test
    void itIsAlwaysTheSame() {
        Mesh again = SnakeMesh.create();

        assertThat(again.positions()).isEqualTo(SNAKE.positions());
        assertThat(again.normals()).isEqualTo(SNAKE.normals());
        assertThat(again.tangents()).isEqualTo(SNAKE.tangents());
        assertThat(again.indices()).isEqualTo(SNAKE.indices());
    }

    @Test
    void itsSkinIsClosedAndWithoutDegenerateTriangles() {
        MeshChecks.assertClosed(SNAKE);
        MeshChecks.assertNoDegenerateTriangle(SNAKE);
    }

    @Test
    void itsFramesAreOrthonormalAndFaceOutwards() {
        MeshChecks.assertOrthonormalFrames(SNAKE);
        // Scales tilt normals by some 15 degrees, and the facets at the snout's point by up to 75 against its axis.
        MeshChecks.assertNormalsFaceOutwards(SNAKE, 0.2);
    }

    @Test
    void itLiesOnTheGround() {
        float lowest = Float.POSITIVE_INFINITY;
        for (int i = 2; i < SNAKE.positions().length; i += 3) {
            lowest = Math.min(lowest, SNAKE.positions()[i]);
        }
        // A tenth of a millimetre: less than a pixel of any picture of the whole snake.
        assertThat(lowest).isBetween(-1e-4f, 1e-4f);
        assertThat(SURFACE.length()).isBetween(1.2, 1.4);
    }

    @Test
    void tangentsRunAlongTheBodyTowardsTheTail() {
        for (int vertex = 0; vertex < SNAKE.vertices(); vertex++) {
            double place = SNAKE.textureCoordinates()[2 * vertex];
            // At the two tips the skin faces forwards or backwards; tangents are its sides' there.
            if (place > 0.007 && place < 0.995) {
                double cosine = MeshChecks.tangent(SNAKE, vertex).dot(SURFACE.direction(place));
                // Head and neck widen by up to 45 degrees against the centre line, at 0.02; the body hardly.
                assertThat(cosine).isGreaterThan(place > 0.045 ? 0.9 : 0.6);
            }
        }
    }

    @Test
    void tangentAndBitangentFollowTheTexture() {
        int tips = 2 * 36;
        float[] uv = SNAKE.textureCoordinates();
        int followed = 0;
        for (int triangle = 0; triangle < SNAKE.triangles() - tips; triangle++) {
            int a = SNAKE.indices()[3 * triangle];
            int b = SNAKE.indices()[3 * triangle + 1];
            int c = SNAKE.indices()[3 * triangle + 2];
            TriangleTangent texture = TriangleTangent.of(
                    new RawMesh(SNAKE.positions(), uv, SNAKE.normals(), new int[] {a, a, a, b, b, b, c, c, c}), 0);
            assertThat(texture.mirrored()).isFalse();
            double cosine = texture.along().normalize().dot(MeshChecks.tangent(SNAKE, a));
            followed += cosine > 0.95 ? 1 : 0;
        }
        // All but facets at the eyes and the snout, where the skin bends within a facet.
        assertThat(followed).isGreaterThan((int) (0.99 * (SNAKE.triangles() - tips)));
    }

    @Test
    void textureCoordinatesHaveNoSeamButTheOneUnderTheBelly() {
        float[] uv = SNAKE.textureCoordinates();
        Map<Vector3d, float[]> coordinates = new HashMap<>();
        for (int i = 0; i < SNAKE.indices().length; i++) {
            int vertex = SNAKE.indices()[i];
            int next = SNAKE.indices()[i / 3 * 3 + (i + 1) % 3];
            // One ring is at most 1/200 of the body; one column at most 1.3/36 of the round, half of it more at tips.
            assertThat(Math.abs(uv[2 * vertex] - uv[2 * next])).isLessThan(0.006f);
            assertThat(Math.abs(uv[2 * vertex + 1] - uv[2 * next + 1])).isLessThan(0.06f);

            float[] other = coordinates.putIfAbsent(
                    MeshChecks.position(SNAKE, vertex), new float[] {uv[2 * vertex], uv[2 * vertex + 1]});
            boolean tip = uv[2 * vertex] == 0 || uv[2 * vertex] == 1;
            if (other != null && !tip) {
                assertThat(other[0]).isEqualTo(uv[2 * vertex]);
                float around = Math.abs(other[1] - uv[2 * vertex + 1]);
                assertThat(around == 0 || around == 1).isTrue();
            }
        }
    }

    @Test
    void vertexNormalsAreEqualOnBothSidesOfTheSeam() {
        Map<Vector3d, Vector3d> normals = new HashMap<>();
        for (int vertex = 0; vertex < SNAKE.vertices() - 2 * 36; vertex++) {
            Vector3d normal = MeshChecks.normal(SNAKE, vertex);
            Vector3d other = normals.putIfAbsent(MeshChecks.position(SNAKE, vertex), normal);
            if (other != null) {
                assertThat(other.distance(normal)).isCloseTo(0, within(MeshChecks.ROUNDING));
            }
        }
    }

    @Test
    void noPartOfTheBodyRunsThroughAnother() {
        SnakeProfile profile = new SnakeProfile();
        SnakePath path = new SnakePath(profile);
        int sections = 400;
        for (int i = 0; i <= sections; i++) {
            double place = (double) i / sections;
            Vector3d center = path.at(place);
            Vector3d forward = SURFACE.direction(place);
            Vector3d right = new Vector3d(forward).cross(0, 0, 1).normalize();
            Vector3d up = right.cross(forward, new Vector3d());
            for (int vertex = 0; vertex < SNAKE.vertices(); vertex += 3) {
                double other = SNAKE.textureCoordinates()[2 * vertex];
                Vector3d relative = MeshChecks.position(SNAKE, vertex).sub(center);
                // The neighborhood along the body always touches; a coil's inner side is 0.1 of the body long.
                if (Math.abs(other - place) > 0.06 && Math.abs(relative.dot(forward)) < SURFACE.length() / sections) {
                    double x = relative.dot(right) / profile.halfWidth(place);
                    double height = relative.dot(up);
                    double y = height / (height > 0 ? profile.halfHeight(place) : profile.bellyDepth(place));
                    // 1 is touching; 3 % less is a fifth of a millimetre, hidden between the coils.
                    assertThat(x * x + y * y)
                            .as("skin at %s inside the body at %s", other, place)
                            .isGreaterThan(0.97 * 0.97);
                }
            }
        }
    }

    @Test
    void scalesTiltTheNormalsOfTheBackButNotOfTheBelly() {
        double back = 0;
        double belly = 0;
        for (int vertex = 0; vertex < SNAKE.vertices() - 2 * 36; vertex++) {
            double u = SNAKE.textureCoordinates()[2 * vertex];
            double v = SNAKE.textureCoordinates()[2 * vertex + 1];
            Vector3d smooth = SURFACE.frame(u, 2 * Math.PI * v).normal();
            double tilt = smooth.angle(MeshChecks.normal(SNAKE, vertex));
            if (u > 0.2 && u < 0.8 && v > 0.35 && v < 0.65) {
                back = Math.max(back, tilt);
            } else if (v < 0.08 || v > 0.92) {
                belly = Math.max(belly, tilt);
            }
        }
        // Subtle: enough to see the scales one by one, not so much that the body's own shading is lost.
        assertThat(Math.toDegrees(back)).isBetween(8.0, 25.0);
        // Texture coordinates in float32 find the smooth frame again to this angle.
        assertThat(belly).isLessThan(1e-3);
    }

    @Test
    void theHeadIsWiderThanTheNeckAndTheTailTapers() {
        SnakeProfile profile = new SnakeProfile();

        assertThat(profile.halfWidth(0.02)).isGreaterThan(1.5 * profile.halfWidth(SnakeProfile.NECK));
        assertThat(profile.halfWidth(0.45)).isGreaterThan(1.8 * profile.halfWidth(SnakeProfile.NECK));
        for (double place = 0.6; place < 0.99; place += 0.01) {
            assertThat(profile.halfWidth(place + 0.01)).isLessThan(profile.halfWidth(place));
        }
    }
}
