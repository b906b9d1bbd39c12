package sunbeam.app.scene.mesh;

import java.util.stream.IntStream;
import org.joml.Vector3dc;

/** Collects vertices and triangles of a generated mesh. Right-handed tangent frames. */
final class MeshBuilder {
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList tangents = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final IntStream.Builder indices = IntStream.builder();

    /** Adds a vertex and returns its number; normal and tangent are orthonormal. */
    int vertex(Vector3dc position, Vector3dc normal, Vector3dc tangent, double u, double v) {
        int number = positions.size() / 3;
        add(positions, position);
        add(normals, normal);
        add(tangents, tangent);
        tangents.add(1);
        textureCoordinates.add((float) u);
        textureCoordinates.add((float) v);
        return number;
    }

    private static void add(FloatList list, Vector3dc vector) {
        list.add((float) vector.x());
        list.add((float) vector.y());
        list.add((float) vector.z());
    }

    /** Adds a triangle, counter-clockwise seen from outside. */
    void triangle(int first, int second, int third) {
        indices.add(first);
        indices.add(second);
        indices.add(third);
    }

    /** @param closed whether the triangles enclose a body */
    Mesh build(boolean closed) {
        return new Mesh(
                positions.toArray(),
                normals.toArray(),
                tangents.toArray(),
                textureCoordinates.toArray(),
                indices.build().toArray(),
                closed);
    }
}
