package sunbeam.app.scene.mesh.format;

import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.joml.Vector3d;
import sunbeam.precompute.files.InputException;

/** Collects a file's geometry; refuses numbers and amounts beyond the limits of meshes. */
final class RawMeshBuilder {
    /**
     * Largest number of positions, normals, texture coordinates or triangles. It fits into a heap of 1 GiB and is a hundred times the
     * thesis's snake.
     */
    static final int MOST_ELEMENTS = 2_000_000;

    /** Corners of one face; the time of its triangulation grows with their square. */
    static final int MOST_POLYGON_CORNERS = 1000;

    // Largest magnitude of a coordinate; beyond it squared areas leave float32's range.
    private static final double FARTHEST = 1e9;

    // In double precision, because meshes may lie far from the origin.
    private final ResizableDoubleArray positions = new ResizableDoubleArray(64);
    private final FloatList textureCoordinates = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList tangents = new FloatList();
    private final IntStream.Builder corners = IntStream.builder();
    private int triangles;

    int positions() {
        return positions.getNumElements() / 3;
    }

    int textureCoordinates() {
        return textureCoordinates.size() / 2;
    }

    int normals() {
        return normals.size() / 3;
    }

    void addPosition(double... xyz) {
        add("position", positions(), positions::addElement, xyz);
    }

    void addTextureCoordinate(double... uv) {
        add("texture coordinate", textureCoordinates(), textureCoordinates::add, uv);
    }

    void addNormal(double... xyz) {
        add("normal", normals(), normals::add, xyz);
    }

    /** Adds the tangent of a normal, with its handedness. Either all normals have one or none. */
    void addTangent(double... xyzHand) {
        add("tangent", tangents.size() / 4, tangents::add, xyzHand);
    }

    private static void add(String what, int before, DoubleConsumer list, double... values) {
        requireRoom(before + 1L, what);
        for (double value : values) {
            if (!(Math.abs(value) <= FARTHEST)) {
                throw new InputException(value + " is no finite number up to 1e9; repair the mesh or export it again");
            }
            list.accept(value);
        }
    }

    /** Checks that the mesh may get more positions and triangles. */
    void requireRoom(int morePositions, int moreTriangles) {
        requireRoom(positions() + (long) morePositions, "position");
        requireRoom(triangles + (long) moreTriangles, "triangle");
    }

    private static void requireRoom(long count, String what) {
        if (count > MOST_ELEMENTS) {
            throw new InputException("more than " + MOST_ELEMENTS + " " + what + "s; simplify the mesh");
        }
    }

    private Vector3d position(int index) {
        return new Vector3d(
                positions.getElement(3 * index),
                positions.getElement(3 * index + 1),
                positions.getElement(3 * index + 2));
    }

    static void requireCorners(int count) {
        if (count < 3 || count > MOST_POLYGON_CORNERS) {
            throw new InputException("a face has " + count + " corners; 3 to " + MOST_POLYGON_CORNERS + " can be used");
        }
    }

    /** Adds a face as triangles; a corner has three indices: position, texture coordinate or -1, normal or -1. */
    void addFace(int[] polygon) {
        requireRoom(0, polygon.length / 3 - 2);
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
