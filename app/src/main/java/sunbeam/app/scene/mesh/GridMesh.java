package sunbeam.app.scene.mesh;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A mesh over a rectangle of parameters. */
final class GridMesh {
    private GridMesh() {}

    /** A surface point with its frame; normal and tangent orthonormal. */
    record Point(Vector3dc position, Vector3dc normal, Vector3dc tangent) {}

    /** A surface; normal = tangent x (direction in which v grows), so that the grid is right-handed. */
    interface Surface {
        /** The point at (u, v), both in [0, 1]; they are the texture coordinates too. */
        Point at(double u, double v);
    }

    /** Samples a surface; (columns + 1) (rows + 1) vertices. Cells that an edge shrinks to a point lose that triangle. */
    static void add(MeshBuilder builder, int columns, int rows, Surface surface) {
        int[][] vertices = new int[rows + 1][columns + 1];
        Vector3d[][] places = new Vector3d[rows + 1][columns + 1];
        for (int row = 0; row <= rows; row++) {
            for (int column = 0; column <= columns; column++) {
                double u = (double) column / columns;
                double v = (double) row / rows;
                Point point = surface.at(u, v);
                places[row][column] = new Vector3d(point.position());
                vertices[row][column] = builder.vertex(point.position(), point.normal(), point.tangent(), u, v);
            }
        }
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                if (differ(places[row][column], places[row][column + 1])) {
                    builder.triangle(vertices[row][column], vertices[row][column + 1], vertices[row + 1][column + 1]);
                }
                if (differ(places[row + 1][column], places[row + 1][column + 1])) {
                    builder.triangle(vertices[row][column], vertices[row + 1][column + 1], vertices[row + 1][column]);
                }
            }
        }
    }

    /** Compares numbers, not bits: 0 and -0 are one place. */
    private static boolean differ(Vector3dc one, Vector3dc other) {
        return one.distanceSquared(other) > 0;
    }
}
