package sunbeam.app.scene.mesh.format;

import java.util.stream.IntStream;

/** Collects what a file gives, within {@link MeshLimits}, which its callers check. */
final class RawMeshBuilder {
    final FloatList positions = new FloatList();
    final FloatList textureCoordinates = new FloatList();
    final FloatList normals = new FloatList();
    /** Empty, or four numbers for each normal. */
    final FloatList tangents = new FloatList();

    private final IntStream.Builder corners = IntStream.builder();
    private int triangles;

    int triangles() {
        return triangles;
    }

    /** Adds a face, each corner a position, a texture coordinate or -1, a normal or -1, as triangles. */
    void face(int[] polygon) {
        for (int corner : PolygonTriangulation.of(positions, polygon)) {
            for (int kind = 0; kind < 3; kind++) {
                corners.add(polygon[3 * corner + kind]);
            }
        }
        triangles += polygon.length / 3 - 2;
    }

    RawMesh build() {
        return new RawMesh(
                positions.toArray(),
                textureCoordinates.toArray(),
                normals.toArray(),
                tangents.toArray(),
                corners.build().toArray());
    }
}
