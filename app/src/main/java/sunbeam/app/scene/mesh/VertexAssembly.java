package sunbeam.app.scene.mesh;

import java.util.HashMap;
import java.util.Map;
import org.joml.Vector3d;

/**
 * Makes vertices of corners: corners become one vertex if they share position, texture coordinate, normal and
 * handedness. Each vertex's tangent is the mean of its triangles', weighted by area and made orthogonal to the normal.
 */
final class VertexAssembly {
    private final RawMesh mesh;
    private final boolean alwaysRightHanded;
    private final CornerNormals cornerNormals;
    private final int[] indices;
    private final Map<Vertex, Integer> numbers = new HashMap<>();
    private final IntList corners = new IntList();
    private final IntList normalKeys = new IntList();
    private final IntList handedness = new IntList();
    private long computedNormals;
    private int undirected;

    /** What corners of one vertex have in common. */
    private record Vertex(int position, int textureCoordinate, int normalKey, int hand) {}

    /**
     * Prepares the work of {@link #assemble}.
     *
     * @param mesh with texture coordinates at all corners
     * @param alwaysRightHanded true to take a mirrored texture for a right-handed one
     */
    VertexAssembly(RawMesh mesh, boolean alwaysRightHanded) {
        this.mesh = mesh;
        this.alwaysRightHanded = alwaysRightHanded;
        this.cornerNormals = new CornerNormals(mesh);
        this.indices = new int[mesh.cornerCount()];
    }

    /** Vertices whose normal was computed. */
    long computedNormals() {
        return computedNormals;
    }

    /** Vertices whose texture gives no direction; their tangent follows x. */
    int undirected() {
        return undirected;
    }

    Mesh assemble() {
        FloatList sums = new FloatList();
        for (int first = 0; first < indices.length; first += 3) {
            TriangleTangent tangent = TriangleTangent.of(mesh, first);
            int hand = tangent.mirrored() && !alwaysRightHanded ? -1 : 1;
            for (int corner = first; corner < first + 3; corner++) {
                indices[corner] = vertexOf(corner, hand, sums);
                sums.accumulate(3 * indices[corner], tangent.along());
            }
        }
        return mesh(sums.toArray());
    }

    private int vertexOf(int corner, int hand, FloatList sums) {
        int key = cornerNormals.key(corner);
        int next = corners.size();
        int vertex = numbers.computeIfAbsent(
                new Vertex(mesh.position(corner), mesh.textureCoordinate(corner), key, hand), met -> next);
        if (vertex < next) {
            return vertex;
        }
        corners.add(corner);
        normalKeys.add(key);
        handedness.add(hand);
        for (int i = 0; i < 3; i++) {
            sums.add(0);
        }
        return vertex;
    }

    private Mesh mesh(float[] sums) {
        int count = corners.size();
        // A file's triangles may leave holes, cross each other, or be turned inside out.
        Mesh result = new Mesh(
                new float[3 * count], new float[3 * count], new float[4 * count], new float[2 * count], indices, false);
        for (int vertex = 0; vertex < count; vertex++) {
            int corner = corners.get(vertex);
            int key = normalKeys.get(vertex);
            computedNormals += key < 0 ? 1 : 0;
            Vector3d normal = cornerNormals.normal(corner, key);
            put(result.positions(), 3 * vertex, mesh.positionOf(corner));
            put(result.normals(), 3 * vertex, normal);
            put(result.tangents(), 4 * vertex, tangent(RawMesh.vector(sums, vertex), normal));
            result.tangents()[4 * vertex + 3] = handedness.get(vertex);
            System.arraycopy(
                    mesh.textureCoordinates(),
                    2 * mesh.textureCoordinate(corner),
                    result.textureCoordinates(),
                    2 * vertex,
                    2);
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
        Vector3d tangent = across(sum, normal);
        if (length > 0 && tangent.length() > 1e-4 * length) {
            return tangent.normalize();
        }
        undirected++;
        Vector3d alongX = across(new Vector3d(1, 0, 0), normal);
        // Where the surface faces along x, y lies in it.
        return alongX.length() > 0.1
                ? alongX.normalize()
                : across(new Vector3d(0, 1, 0), normal).normalize();
    }

    /** The part of a vector that lies in the surface. */
    private static Vector3d across(Vector3d vector, Vector3d normal) {
        return new Vector3d(vector).fma(-vector.dot(normal), normal);
    }
}
