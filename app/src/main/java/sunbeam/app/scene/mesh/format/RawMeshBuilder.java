package sunbeam.app.scene.mesh.format;

import java.util.stream.IntStream;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.joml.Vector3d;

/** Collects a file's geometry; callers check {@link MeshLimits}. */
final class RawMeshBuilder {
    /** In double precision, because meshes may lie far from the origin. */
    final ResizableDoubleArray positions = new ResizableDoubleArray(64);

    final FloatList textureCoordinates = new FloatList();
    final FloatList normals = new FloatList();
    /** Empty, or four numbers for each normal. */
    final FloatList tangents = new FloatList();

    private final IntStream.Builder corners = IntStream.builder();
    private int triangles;

    int triangles() {
        return triangles;
    }

    int vertices() {
        return positions.getNumElements() / 3;
    }

    Vector3d position(int index) {
        return new Vector3d(
                positions.getElement(3 * index),
                positions.getElement(3 * index + 1),
                positions.getElement(3 * index + 2));
    }

    /** Adds a face as triangles; a corner has three indices: position, texture coordinate or -1, normal or -1. */
    void face(int[] polygon) {
        for (int corner : PolygonTriangulation.of(this::position, polygon)) {
            for (int kind = 0; kind < 3; kind++) {
                corners.add(polygon[3 * corner + kind]);
            }
        }
        triangles += polygon.length / 3 - 2;
    }

    RawMesh build() {
        return new RawMesh(
                positions.getElements(),
                textureCoordinates.toArray(),
                normals.toArray(),
                tangents.toArray(),
                corners.build().toArray());
    }
}
