package sunbeam.app.scene.mesh;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;

/**
 * Divides polygons, also concave ones, into triangles by cutting off ears (Meisters 1975), in the polygon's mean plane
 * (Newell's normal).
 */
final class PolygonTriangulation {
    private final List<Integer> rest = new ArrayList<>();
    private final double[] x;
    private final double[] y;
    private final int start;

    private PolygonTriangulation(float[] positions, int[] corners, int start, int end) {
        this.start = start;
        int count = end - start;
        Vector3d[] points = new Vector3d[count];
        for (int i = 0; i < count; i++) {
            points[i] = RawMesh.vector(positions, corners[3 * (start + i)]);
            rest.add(i);
        }
        Vector3d normal = newellNormal(points);
        Vector3d axis = Math.abs(normal.x) < 0.6 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
        Vector3d right = axis.fma(-axis.dot(normal), normal).normalize();
        Vector3d up = normal.cross(right, new Vector3d());
        x = new double[count];
        y = new double[count];
        for (int i = 0; i < count; i++) {
            Vector3d relative = points[i].sub(points[0], new Vector3d());
            x[i] = relative.dot(right);
            y[i] = relative.dot(up);
        }
    }

    /**
     * Corner numbers, three per triangle.
     *
     * @param corners three indices per corner, position first
     * @param start, end the polygon's corners
     */
    static int[] of(float[] positions, int[] corners, int start, int end) {
        if (end - start == 3) {
            return new int[] {start, start + 1, start + 2};
        }
        return new PolygonTriangulation(positions, corners, start, end).cut();
    }

    private static Vector3d newellNormal(Vector3d[] points) {
        Vector3d normal = new Vector3d();
        for (int i = 0; i < points.length; i++) {
            Vector3d one = points[i].sub(points[0], new Vector3d());
            Vector3d next = points[(i + 1) % points.length].sub(points[0], new Vector3d());
            normal.add(one.cross(next));
        }
        // A polygon without area has no plane; any will do, since its triangles are dropped as degenerate.
        return normal.length() > 0 ? normal.normalize() : new Vector3d(0, 0, 1);
    }

    private int[] cut() {
        int[] triangles = new int[3 * (rest.size() - 2)];
        int next = 0;
        while (rest.size() > 3) {
            int ear = ear();
            for (int step = -1; step <= 1; step++) {
                triangles[next++] = start + at(ear + step);
            }
            rest.remove(ear);
        }
        for (int corner : rest) {
            triangles[next++] = start + corner;
        }
        return triangles;
    }

    private int at(int index) {
        return rest.get(Math.floorMod(index, rest.size()));
    }

    /**
     * The first ear from the second corner on, so that a convex polygon becomes the usual fan about its first corner. A
     * polygon that crosses itself may have none; its second corner is cut off then.
     */
    private int ear() {
        for (int step = 1; step <= rest.size(); step++) {
            int i = step % rest.size();
            if (turn(at(i - 1), at(i), at(i + 1)) > 0 && isEmpty(i)) {
                return i;
            }
        }
        return 1;
    }

    private boolean isEmpty(int i) {
        int before = at(i - 1);
        int tip = at(i);
        int after = at(i + 1);
        for (int other : rest) {
            if (other != before
                    && other != tip
                    && other != after
                    && turn(before, tip, other) >= 0
                    && turn(tip, after, other) >= 0
                    && turn(after, before, other) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** Twice the area of a triangle; positive if it turns left. */
    private double turn(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
}
