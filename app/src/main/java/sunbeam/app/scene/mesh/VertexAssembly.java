package sunbeam.app.scene.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3f;

/**
 * Merges corners of equal position, texture coordinate, normal and handedness into vertices. A vertex has the file's tangent, or the mean
 * of its triangles' tangents, weighted by area; both are made orthogonal to the normal.
 *
 * <p>The normal is the file's, else the mean over the triangles around the position, weighted by area. Copies of a position, at seams and
 * hard edges, have the mean over all copies if the angle to their own is small.
 */
final class VertexAssembly {
    // Cosine of 41 degrees. A hard edge of 90 stays hard: the mean over it is 45 from either side.
    private static final double LEAST_COSINE = 0.75;

    private final RawMesh mesh;
    private final boolean alwaysRightHanded;
    // Sums over the triangles around each position; each has 3 values.
    private final float[] normalSums;
    private final int[] indices;
    private final Map<Vertex, Integer> numbers = new HashMap<>();
    private final List<Vertex> vertices = new ArrayList<>();
    private final List<Vector3f> tangents = new ArrayList<>();
    private int undirected;

    /** @param along direction of growing u (Lengyel 2001), twice the triangle's area long; zero if the texture has no area */
    private record TriangleTangent(Vector3d along, boolean mirrored) {

        static TriangleTangent of(RawMesh mesh, int first) {
            float[] uv = mesh.textureCoordinates();
            int a = 2 * mesh.textureCoordinate(first);
            int b = 2 * mesh.textureCoordinate(first + 1);
            int c = 2 * mesh.textureCoordinate(first + 2);
            double u1 = (double) uv[b] - uv[a];
            double v1 = (double) uv[b + 1] - uv[a + 1];
            double u2 = (double) uv[c] - uv[a];
            double v2 = (double) uv[c + 1] - uv[a + 1];
            double area = u1 * v2 - u2 * v1;
            double size = (Math.abs(u1) + Math.abs(u2)) * (Math.abs(v1) + Math.abs(v2));
            // In float32 a thinner triangle cannot be distinguished from a line.
            if (Math.abs(area) <= 1e-9 * size) {
                return new TriangleTangent(new Vector3d(), false);
            }
            Vector3d origin = mesh.positionOf(first);
            Vector3d edge1 = mesh.positionOf(first + 1).sub(origin);
            Vector3d edge2 = mesh.positionOf(first + 2).sub(origin);
            Vector3d along = edge1.mul(v2).sub(edge2.mul(v1)).mul(Math.signum(area));
            double length = along.length();
            return length == 0
                    ? new TriangleTangent(along, false)
                    : new TriangleTangent(along.mul(mesh.areaNormal(first).length() / length), area < 0);
        }
    }

    private record Vertex(int position, int textureCoordinate, int normalKey, int hand) {}

    VertexAssembly(RawMesh mesh, boolean alwaysRightHanded) {
        this.mesh = mesh;
        this.alwaysRightHanded = alwaysRightHanded;
        this.indices = new int[mesh.cornerCount()];
        this.normalSums = areaNormals(mesh);
        if (IntStream.range(0, mesh.cornerCount()).anyMatch(corner -> mesh.normal(corner) < 0)) {
            shareMeans();
        }
    }

    /** @param warning accepts a line about each kind of data that is computed */
    Mesh assemble(Consumer<String> warning) {
        for (int first = 0; first < indices.length; first += 3) {
            TriangleTangent tangent = TriangleTangent.of(mesh, first);
            int textureHand = tangent.mirrored() && !alwaysRightHanded ? -1 : 1;
            for (int corner = first; corner < first + 3; corner++) {
                int key = key(corner);
                int hand = mesh.hasTangent(key) ? mesh.hand(key) : textureHand;
                Vertex vertex = new Vertex(mesh.position(corner), mesh.textureCoordinate(corner), key, hand);
                indices[corner] = numbers.computeIfAbsent(vertex, this::addVertex);
                tangents.get(indices[corner]).add(new Vector3f(tangent.along()));
            }
        }
        Mesh result = toMesh();
        long computed =
                vertices.stream().filter(vertex -> vertex.normalKey() < 0).count();
        if (computed > 0) {
            warning.accept("computed normals for " + computed + " of " + MeshSource.count(vertices.size(), "vertex"));
        }
        if (!alwaysRightHanded && undirected > 0) {
            warning.accept("the texture gives no direction at " + MeshSource.count(undirected, "vertex")
                    + "; the tangent follows x there");
        }
        return result;
    }

    private int addVertex(Vertex vertex) {
        vertices.add(vertex);
        tangents.add(new Vector3f());
        return vertices.size() - 1;
    }

    private Mesh toMesh() {
        int count = vertices.size();
        // Not known to be closed: a file's triangles may leave holes or be turned inside out.
        Mesh result = new Mesh(
                new float[3 * count], new float[3 * count], new float[4 * count], new float[2 * count], indices, false);
        for (int i = 0; i < count; i++) {
            Vertex vertex = vertices.get(i);
            Vector3d normal = normal(vertex.position(), vertex.normalKey());
            for (int axis = 0; axis < 3; axis++) {
                result.positions()[3 * i + axis] = (float) mesh.positions()[3 * vertex.position() + axis];
            }
            put(result.normals(), 3 * i, normal);
            Vector3d along = mesh.hasTangent(vertex.normalKey())
                    ? mesh.tangentOf(vertex.normalKey())
                    : new Vector3d(tangents.get(i));
            put(result.tangents(), 4 * i, tangent(along, normal));
            result.tangents()[4 * i + 3] = vertex.hand();
            System.arraycopy(
                    mesh.textureCoordinates(), 2 * vertex.textureCoordinate(), result.textureCoordinates(), 2 * i, 2);
        }
        return result;
    }

    private static void put(float[] values, int at, Vector3d vector) {
        values[at] = (float) vector.x;
        values[at + 1] = (float) vector.y;
        values[at + 2] = (float) vector.z;
    }

    private Vector3d tangent(Vector3d sum, Vector3d normal) {
        double length = sum.length();
        Vector3d tangent = tangential(sum, normal);
        if (length > 0 && tangent.length() > 1e-4 * length) {
            return tangent.normalize();
        }
        undirected++;
        Vector3d alongX = tangential(new Vector3d(1, 0, 0), normal);
        return alongX.length() > 0.1
                ? alongX.normalize()
                : tangential(new Vector3d(0, 1, 0), normal).normalize();
    }

    private static Vector3d tangential(Vector3d vector, Vector3d normal) {
        return new Vector3d(vector).fma(-vector.dot(normal), normal);
    }

    private static float[] areaNormals(RawMesh mesh) {
        float[] sums = new float[mesh.positions().length];
        for (int first = 0; first < mesh.cornerCount(); first += 3) {
            Vector3d normal = mesh.areaNormal(first);
            for (int corner = first; corner < first + 3; corner++) {
                int at = 3 * mesh.position(corner);
                sums[at] += (float) normal.x;
                sums[at + 1] += (float) normal.y;
                sums[at + 2] += (float) normal.z;
            }
        }
        return sums;
    }

    private void shareMeans() {
        Map<Vector3d, Vector3d> means = new HashMap<>();
        for (int i = 0; i < normalSums.length / 3; i++) {
            Vector3d own = Mesh.vector(normalSums, i);
            // Unit vectors: the division into triangles must not matter.
            means.computeIfAbsent(position(i), place -> new Vector3d()).fma(1 / Math.max(1e-300, own.length()), own);
        }
        for (int i = 0; i < normalSums.length / 3; i++) {
            Vector3d mean = means.get(position(i));
            Vector3d own = Mesh.vector(normalSums, i);
            if (mean.dot(own) > LEAST_COSINE * mean.length() * own.length()) {
                put(normalSums, 3 * i, mean);
            }
        }
    }

    private Vector3d position(int i) {
        double[] all = mesh.positions();
        // -0.0 becomes 0.0, which has another hash.
        return new Vector3d(all[3 * i] + 0.0, all[3 * i + 1] + 0.0, all[3 * i + 2] + 0.0);
    }

    /** Key that corners of one position share: index of the file's normal, -1 for the mean, or -2 - t for triangle t's. */
    private int key(int corner) {
        int given = mesh.normal(corner);
        if (given >= 0 && Mesh.vector(mesh.normals(), given).length() > 0) {
            return given;
        }
        Vector3d mean = Mesh.vector(normalSums, mesh.position(corner));
        Vector3d own = mesh.areaNormal(corner - corner % 3);
        // Triangles back to back may have a mean of zero or facing the back; they use their own normal.
        return mean.dot(own) > 1e-6 * mean.length() * own.length() ? -1 : -2 - corner / 3;
    }

    private Vector3d normal(int position, int key) {
        if (key >= 0) {
            return Mesh.vector(mesh.normals(), key).normalize();
        }
        Vector3d normal = key == -1 ? Mesh.vector(normalSums, position) : mesh.areaNormal(3 * (-2 - key));
        return normal.normalize();
    }
}
