package sunbeam.app.scene.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;
import org.joml.Vector3f;
import sunbeam.app.scene.mesh.format.RawMesh;

/**
 * Merges corners into vertices: corners become one vertex if they share position, texture coordinate, normal and handedness. A vertex has
 * the file's tangent, or if there is none the mean of its triangles' tangents, weighted by area; both are made orthogonal to the normal.
 */
final class VertexAssembly {
    private final RawMesh mesh;
    private final boolean alwaysRightHanded;
    private final CornerNormals cornerNormals;
    private final int[] indices;
    private final Map<Vertex, Integer> numbers = new HashMap<>();
    private final List<Vertex> vertices = new ArrayList<>();
    private final List<Vector3f> tangents = new ArrayList<>();
    private long computedNormals;
    private int undirected;

    /**
     * Orientation of the texture on a triangle.
     *
     * @param along direction of the texture's growing u (Lengyel 2001), with twice the triangle's area as its length; zero if the texture
     *     has no area
     * @param mirrored whether the texture appears mirrored from outside
     */
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
            // With float32 texture coordinates a thinner triangle cannot be distinguished from a line.
            if (Math.abs(area) <= 1e-9 * size) {
                return new TriangleTangent(new Vector3d(), false);
            }
            Vector3d origin = mesh.positionOf(first);
            Vector3d edge1 = mesh.positionOf(first + 1).sub(origin);
            Vector3d edge2 = mesh.positionOf(first + 2).sub(origin);
            Vector3d along = edge1.mul(v2).sub(edge2.mul(v1)).mul(Math.signum(area));
            double length = along.length();
            if (length == 0) {
                return new TriangleTangent(new Vector3d(), false);
            }
            return new TriangleTangent(along.mul(mesh.areaNormal(first).length() / length), area < 0);
        }
    }

    /** Indices, key of the normal and handedness (1 or -1) that the corners of one vertex share. */
    private record Vertex(int position, int textureCoordinate, int normalKey, int hand) {}

    /** @param alwaysRightHanded whether frames stay right-handed where the texture is mirrored */
    VertexAssembly(RawMesh mesh, boolean alwaysRightHanded) {
        this.mesh = mesh;
        this.alwaysRightHanded = alwaysRightHanded;
        this.cornerNormals = new CornerNormals(mesh);
        this.indices = new int[mesh.cornerCount()];
    }

    long computedNormals() {
        return computedNormals;
    }

    /** Returns the number of vertices for which neither the file's tangent nor the texture gives a direction; their tangent follows x. */
    int undirected() {
        return undirected;
    }

    Mesh assemble() {
        for (int first = 0; first < indices.length; first += 3) {
            TriangleTangent tangent = TriangleTangent.of(mesh, first);
            int textureHand = tangent.mirrored() && !alwaysRightHanded ? -1 : 1;
            for (int corner = first; corner < first + 3; corner++) {
                int key = cornerNormals.key(corner);
                int hand = mesh.hasTangent(key) ? mesh.hand(key) : textureHand;
                Vertex vertex = new Vertex(mesh.position(corner), mesh.textureCoordinate(corner), key, hand);
                indices[corner] = numbers.computeIfAbsent(vertex, this::addVertex);
                tangents.get(indices[corner]).add(new Vector3f(tangent.along()));
            }
        }
        return toMesh();
    }

    private int addVertex(Vertex vertex) {
        vertices.add(vertex);
        tangents.add(new Vector3f());
        return vertices.size() - 1;
    }

    private Mesh toMesh() {
        int count = vertices.size();
        // The mesh is not known to be closed: a file's triangles may leave holes, cross each other, or be turned
        // inside out.
        Mesh result = new Mesh(
                new float[3 * count], new float[3 * count], new float[4 * count], new float[2 * count], indices, false);
        for (int i = 0; i < count; i++) {
            Vertex vertex = vertices.get(i);
            computedNormals += vertex.normalKey() < 0 ? 1 : 0;
            Vector3d normal = cornerNormals.normal(vertex.position(), vertex.normalKey());
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
}
