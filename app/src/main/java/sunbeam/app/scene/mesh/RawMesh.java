package sunbeam.app.scene.mesh;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.joml.Vector3d;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.text.Text;

/**
 * Triangles of a file.
 *
 * @param positions 3 per position, in double precision
 * @param textureCoordinates 2 per texture coordinate
 * @param normals 3 per normal, of any length
 * @param tangents empty, or 4 per normal: a vector x, y, z of any length (0 if the normal has no tangent), then the handedness, negative
 *     for left-handed
 * @param corners 3 per corner, so 9 per triangle: position, texture coordinate or -1, normal or -1
 */
public record RawMesh(
        double[] positions, float[] textureCoordinates, float[] normals, float[] tangents, int[] corners) {
    // Height over longest side of a triangle, below which it is due to rounding.
    private static final double THINNEST = 1e-9;
    // Distance from the origin over longest side; a float32 has steps of 6e-8 of the distance.
    private static final double FAR = 500;

    public int cornerCount() {
        return corners.length / 3;
    }

    public int position(int corner) {
        return corners[3 * corner];
    }

    public int textureCoordinate(int corner) {
        return corners[3 * corner + 1];
    }

    public int normal(int corner) {
        return corners[3 * corner + 2];
    }

    /** A negative index is no normal. */
    public boolean hasTangent(int normal) {
        return normal >= 0 && tangents.length > 0 && tangentOf(normal).length() > 0;
    }

    public Vector3d tangentOf(int normal) {
        return new Vector3d(tangents[4 * normal], tangents[4 * normal + 1], tangents[4 * normal + 2]);
    }

    public int hand(int normal) {
        return tangents[4 * normal + 3] < 0 ? -1 : 1;
    }

    public Vector3d positionOf(int corner) {
        int at = 3 * position(corner);
        return new Vector3d(positions[at], positions[at + 1], positions[at + 2]);
    }

    /** Returns the normal, with twice the triangle's area as its length. */
    public Vector3d areaNormal(int first) {
        Vector3d origin = positionOf(first);
        return positionOf(first + 1).sub(origin).cross(positionOf(first + 2).sub(origin));
    }

    RawMesh scaled(double factor) {
        return withPositions(i -> positions[i] * factor);
    }

    public RawMesh centered(Vector3d center) {
        return withPositions(i -> positions[i] - center.get(i % 3));
    }

    private RawMesh withPositions(IntToDoubleFunction coordinate) {
        double[] moved = new double[positions.length];
        Arrays.setAll(moved, coordinate);
        return new RawMesh(moved, textureCoordinates, normals, tangents, corners);
    }

    private Vector3d[] bounds() {
        Vector3d least = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d most = new Vector3d(Double.NEGATIVE_INFINITY);
        for (int corner = 0; corner < cornerCount(); corner++) {
            Vector3d position = positionOf(corner);
            least.min(position);
            most.max(position);
        }
        return new Vector3d[] {least, most};
    }

    /** Returns the center of a mesh so far away that float32 would change its shape by 3e-5 of its longest side. */
    public Optional<Vector3d> farCenter() {
        Vector3d[] ends = bounds();
        Vector3d size = ends[1].sub(ends[0], new Vector3d());
        Vector3d center = ends[0].add(ends[1]).mul(0.5);
        return center.length() > FAR * size.get(size.maxComponent()) ? Optional.of(center) : Optional.empty();
    }

    /** Drops triangles of no area, which have no normal. */
    public RawMesh withoutDegenerate() {
        int[] remaining = IntStream.range(0, cornerCount() / 3)
                .filter(triangle -> !isDegenerate(3 * triangle))
                .flatMap(triangle -> Arrays.stream(corners, 9 * triangle, 9 * triangle + 9))
                .toArray();
        return new RawMesh(positions, textureCoordinates, normals, tangents, remaining);
    }

    private boolean isDegenerate(int first) {
        Vector3d a = positionOf(first);
        Vector3d b = positionOf(first + 1);
        Vector3d c = positionOf(first + 2);
        double longest = Math.max(a.distanceSquared(b), Math.max(b.distanceSquared(c), c.distanceSquared(a)));
        return areaNormal(first).length() <= THINNEST * longest;
    }

    /** Projects texture coordinates from above, x to u and y to v; the longer side spans 0 to 1. */
    public RawMesh withPlanarCoordinates() {
        Vector3d[] ends = bounds();
        Vector3d size = ends[1].sub(ends[0]);
        double side = Math.max(size.x, size.y);
        double scale = side > 0 ? 1 / side : 1;
        float[] coordinates =
                Floats.of(positions.length / 3 * 2, i -> (positions[3 * (i / 2) + i % 2] - ends[0].get(i % 2)) * scale);
        int[] planar = corners.clone();
        for (int corner = 0; corner < cornerCount(); corner++) {
            planar[3 * corner + 1] = position(corner);
        }
        return new RawMesh(positions, coordinates, normals, tangents, planar);
    }

    /** Collects a file's geometry within the limits of meshes. */
    static final class Builder {
        /** Positions, normals, texture coordinates or triangles: fits into a heap of 1 GiB. */
        static final int MOST_ELEMENTS = 2_000_000;

        /** The time of a face's triangulation grows with the square. */
        static final int MOST_POLYGON_CORNERS = 1000;

        // Beyond this coordinate squared areas leave float32's range.
        private static final double FARTHEST = 1e9;
        // In double precision, since meshes may lie far from the origin.
        private final ResizableDoubleArray positions = new ResizableDoubleArray(64);
        private final Mesh.FloatList textureCoordinates = new Mesh.FloatList();
        private final Mesh.FloatList normals = new Mesh.FloatList();
        private final Mesh.FloatList tangents = new Mesh.FloatList();
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

        static double number(String word) {
            try {
                return Double.parseDouble(word);
            } catch (NumberFormatException wrong) {
                throw new InputException(Text.quoted(word) + " is no number; export the mesh again", wrong);
            }
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

        /** Adds the tangent of a normal; all normals have one or none. */
        void addTangent(double... xyzHand) {
            add("tangent", tangents.size() / 4, tangents::add, xyzHand);
        }

        private static void add(String what, int before, DoubleConsumer list, double... values) {
            requireRoom(before + 1L, what);
            for (double value : values) {
                if (!(Math.abs(value) <= FARTHEST)) {
                    throw new InputException(
                            value + " is no finite number up to 1e9; repair the mesh or export it again");
                }
                list.accept(value);
            }
        }

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
                throw new InputException(
                        "a face has " + count + " corners; 3 to " + MOST_POLYGON_CORNERS + " can be used");
            }
        }

        /** A corner has three indices: position, texture coordinate or -1, normal or -1. */
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
            float[] uv = textureCoordinates.toArray();
            int[] all = corners.build().toArray();
            return new RawMesh(positions.getElements(), uv, normals.toArray(), tangents.toArray(), all);
        }
    }
}
