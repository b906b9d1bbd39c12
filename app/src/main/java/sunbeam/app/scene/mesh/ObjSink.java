package sunbeam.app.scene.mesh;

import de.javagl.obj.AbstractWritableObj;
import de.javagl.obj.FloatTuple;
import de.javagl.obj.ObjFace;

/** Takes what the library reads from an OBJ file into plain arrays, and refuses what is too much or points nowhere. */
final class ObjSink extends AbstractWritableObj {
    private final ObjLines lines;
    private final ObjLimits limits;
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final IntList corners = new IntList();
    private final IntList faceEnds = new IntList();
    private long triangles;

    ObjSink(ObjLines lines, ObjLimits limits) {
        this.lines = lines;
        this.limits = limits;
    }

    @Override
    public void addVertex(FloatTuple vertex) {
        add(positions, vertex, 3, "positions");
    }

    @Override
    public void addNormal(FloatTuple normal) {
        add(normals, normal, 3, "normals");
    }

    @Override
    public void addTexCoord(FloatTuple coordinate) {
        add(textureCoordinates, coordinate, 2, "texture coordinates");
    }

    private void add(FloatList list, FloatTuple tuple, int dimensions, String name) {
        if (list.size() / dimensions >= limits.elements()) {
            throw new MeshException(
                    lines.place() + ": more than " + limits.elements() + " " + name + "; simplify the mesh");
        }
        for (int i = 0; i < dimensions; i++) {
            list.add(tuple.get(i));
        }
    }

    @Override
    public void addFace(ObjFace face) {
        int count = face.getNumVertices();
        if (count < 3 || count > limits.corners()) {
            throw new MeshException(
                    lines.place() + ": a face with " + count + " corners; 3 to " + limits.corners() + " can be used");
        }
        triangles += count - 2;
        if (triangles > limits.triangles()) {
            throw new MeshException(
                    lines.place() + ": more than " + limits.triangles() + " triangles; simplify the mesh");
        }
        for (int i = 0; i < count; i++) {
            corners.add(index(face.getVertexIndex(i), positions, 3, "position"));
            corners.add(
                    face.containsTexCoordIndices()
                            ? index(face.getTexCoordIndex(i), textureCoordinates, 2, "texture coordinate")
                            : -1);
            corners.add(face.containsNormalIndices() ? index(face.getNormalIndex(i), normals, 3, "normal") : -1);
        }
        faceEnds.add(corners.size() / 3);
    }

    private int index(int index, FloatList list, int dimensions, String name) {
        int count = list.size() / dimensions;
        if (index < 0 || index >= count) {
            // As the file has it: negative ones count backwards from the last.
            int written = index < 0 ? index - count : index + 1;
            throw new MeshException(lines.place() + ": the face names " + name + " " + written + " but " + count
                    + " are given above it");
        }
        return index;
    }

    /** Divides polygons. */
    RawMesh toRawMesh() {
        float[] places = positions.toArray();
        int[] all = corners.toArray();
        IntList result = new IntList();
        int start = 0;
        for (int end : faceEnds.toArray()) {
            for (int corner : PolygonTriangulation.of(places, all, start, end)) {
                result.add(all[3 * corner]);
                result.add(all[3 * corner + 1]);
                result.add(all[3 * corner + 2]);
            }
            start = end;
        }
        return new RawMesh(places, textureCoordinates.toArray(), normals.toArray(), result.toArray());
    }
}
