package sunbeam.app.scene.mesh;

import java.util.stream.IntStream;
import org.joml.Vector3dc;
import sunbeam.app.scene.mesh.format.FloatList;

/** Collects vertices and triangles of a generated mesh. All tangent frames are right-handed. */
final class MeshBuilder {
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList tangents = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final IntStream.Builder indices = IntStream.builder();

    /** Position in meters, outward unit normal, and unit tangent orthogonal to it. */
    record Point(Vector3dc position, Vector3dc normal, Vector3dc tangent) {}

    /** Adds a vertex and returns its index. */
    int vertex(Point point, double u, double v) {
        int number = positions.size() / 3;
        add(positions, point.position);
        add(normals, point.normal);
        add(tangents, point.tangent);
        tangents.add(1);
        textureCoordinates.add(u);
        textureCoordinates.add(v);
        return number;
    }

    private static void add(FloatList list, Vector3dc vector) {
        list.add(vector.x());
        list.add(vector.y());
        list.add(vector.z());
    }

    void triangle(int first, int second, int third) {
        indices.add(first);
        indices.add(second);
        indices.add(third);
    }

    /** Parametric surface over (u, v) in [0, 1]; normal = tangent x (direction of growing v), so that the grid is right-handed. */
    interface Surface {
        Point at(double u, double v);
    }

    /** Samples a surface with (columns + 1) (rows + 1) vertices. A cell with an edge of length 0 gets one triangle. */
    MeshBuilder grid(int columns, int rows, Surface surface) {
        int[][] vertices = new int[rows + 1][columns + 1];
        Vector3dc[][] points = new Vector3dc[rows + 1][columns + 1];
        for (int row = 0; row <= rows; row++) {
            for (int column = 0; column <= columns; column++) {
                double u = (double) column / columns;
                double v = (double) row / rows;
                Point point = surface.at(u, v);
                points[row][column] = point.position();
                vertices[row][column] = vertex(point, u, v);
            }
        }
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                if (differ(points[row][column], points[row][column + 1])) {
                    triangle(vertices[row][column], vertices[row][column + 1], vertices[row + 1][column + 1]);
                }
                if (differ(points[row + 1][column], points[row + 1][column + 1])) {
                    triangle(vertices[row][column], vertices[row + 1][column + 1], vertices[row + 1][column]);
                }
            }
        }
        return this;
    }

    private static boolean differ(Vector3dc one, Vector3dc other) {
        return one.distanceSquared(other) > 0;
    }

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
