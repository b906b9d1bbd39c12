package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import org.joml.Vector3d;

public final class MeshChecks {
    // Components rounded to float32.
    public static final double ROUNDING = 1e-6;

    private MeshChecks() {}

    public static Vector3d position(Mesh mesh, int vertex) {
        return Mesh.vector(mesh.positions(), vertex);
    }

    public static Vector3d normal(Mesh mesh, int vertex) {
        return Mesh.vector(mesh.normals(), vertex);
    }

    public static Vector3d tangent(Mesh mesh, int vertex) {
        float[] values = mesh.tangents();
        return new Vector3d(values[4 * vertex], values[4 * vertex + 1], values[4 * vertex + 2]);
    }

    /** Normal of a triangle, with twice its area as its length. */
    static Vector3d areaNormal(Mesh mesh, int triangle) {
        int[] indices = mesh.indices();
        Vector3d a = position(mesh, indices[3 * triangle]);
        Vector3d b = position(mesh, indices[3 * triangle + 1]).sub(a);
        Vector3d c = position(mesh, indices[3 * triangle + 2]).sub(a);
        return b.cross(c);
    }

    static double area(Mesh mesh) {
        return IntStream.range(0, mesh.triangles())
                .mapToDouble(triangle -> areaNormal(mesh, triangle).length() / 2)
                .sum();
    }

    static void assertOrthonormalFrames(Mesh mesh) {
        for (int vertex = 0; vertex < mesh.vertices(); vertex++) {
            Vector3d normal = normal(mesh, vertex);
            Vector3d tangent = tangent(mesh, vertex);
            assertThat(normal.length()).isCloseTo(1, within(ROUNDING));
            assertThat(tangent.length()).isCloseTo(1, within(ROUNDING));
            assertThat(normal.dot(tangent)).isCloseTo(0, within(ROUNDING));
            assertThat(Math.abs(mesh.tangents()[4 * vertex + 3])).isEqualTo(1);
        }
    }

    /** Fails also for a triangle without area, whose normal is no number. */
    static void assertNormalsFaceOutwards(Mesh mesh, double leastCosine) {
        for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
            Vector3d face = areaNormal(mesh, triangle).normalize();
            for (int i = 0; i < 3; i++) {
                int vertex = mesh.indices()[3 * triangle + i];
                assertThat(face.dot(normal(mesh, vertex)))
                        .as("vertex %d of triangle %d", vertex, triangle)
                        .isGreaterThan(leastCosine);
            }
        }
    }

    static void assertClosed(Mesh mesh) {
        Map<Vector3d, Integer> places = new HashMap<>();
        Map<Long, Integer> edges = new HashMap<>();
        for (int i = 0; i < mesh.indices().length; i++) {
            int triangle = i / 3 * 3;
            int from = place(places, position(mesh, mesh.indices()[i]));
            int to = place(places, position(mesh, mesh.indices()[triangle + (i + 1) % 3]));
            edges.merge((long) Math.min(from, to) << 32 | Math.max(from, to), from < to ? 1 : -1, Integer::sum);
        }
        assertThat(edges.values()).containsOnly(0);
    }

    private static int place(Map<Vector3d, Integer> places, Vector3d position) {
        // Adding zero makes -0 equal to 0.
        return places.computeIfAbsent(position.add(0, 0, 0), key -> places.size());
    }

    /** Asserts that tangent and bitangent point where u and v grow. */
    static void assertTangentsFollowTheTexture(Mesh mesh, double leastCosine) {
        float[] uv = mesh.textureCoordinates();
        for (int triangle = 0; triangle < mesh.triangles(); triangle++) {
            int a = mesh.indices()[3 * triangle];
            int b = mesh.indices()[3 * triangle + 1];
            int c = mesh.indices()[3 * triangle + 2];
            double u1 = (double) uv[2 * b] - uv[2 * a];
            double v1 = (double) uv[2 * b + 1] - uv[2 * a + 1];
            double u2 = (double) uv[2 * c] - uv[2 * a];
            double v2 = (double) uv[2 * c + 1] - uv[2 * a + 1];
            Vector3d e1 = position(mesh, b).sub(position(mesh, a));
            Vector3d e2 = position(mesh, c).sub(position(mesh, a));
            double sign = Math.signum(u1 * v2 - u2 * v1);
            Vector3d along = new Vector3d(e1)
                    .mul(sign * v2)
                    .sub(new Vector3d(e2).mul(sign * v1))
                    .normalize();
            Vector3d across = new Vector3d(e2)
                    .mul(sign * u1)
                    .sub(new Vector3d(e1).mul(sign * u2))
                    .normalize();
            for (int vertex : new int[] {a, b, c}) {
                Vector3d tangent = tangent(mesh, vertex);
                Vector3d bitangent = normal(mesh, vertex).cross(tangent).mul(mesh.tangents()[4 * vertex + 3]);
                assertThat(tangent.dot(along)).isGreaterThan(leastCosine);
                assertThat(bitangent.dot(across)).isGreaterThan(leastCosine);
            }
        }
    }
}
