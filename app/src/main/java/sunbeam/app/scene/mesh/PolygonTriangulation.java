package sunbeam.app.scene.mesh;

import java.nio.IntBuffer;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.joml.Vector3d;

/** Divides polygons, also concave ones, by cutting off ears (Meisters 1975) in the mean plane (Newell's normal); O(n^2) at worst. */
final class PolygonTriangulation {
    private final int[] previous;
    private final int[] next;
    private final boolean[] isReflex;
    private final boolean[] isEar;
    private final double[] x;
    private final double[] y;

    private PolygonTriangulation(IntFunction<Vector3d> positions, int[] polygon) {
        int count = polygon.length / 3;
        previous = new int[count];
        next = new int[count];
        isReflex = new boolean[count];
        isEar = new boolean[count];
        Vector3d[] points = new Vector3d[count];
        for (int i = 0; i < count; i++) {
            points[i] = positions.apply(polygon[3 * i]);
            previous[i] = (i + count - 1) % count;
            next[i] = (i + 1) % count;
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

    /** Returns corner numbers, three per triangle; the polygon has three indices per corner, position first. */
    static int[] of(IntFunction<Vector3d> positions, int[] polygon) {
        return polygon.length == 9 ? new int[] {0, 1, 2} : new PolygonTriangulation(positions, polygon).cut();
    }

    private static Vector3d newellNormal(Vector3d[] points) {
        Vector3d normal = new Vector3d();
        for (int i = 0; i < points.length; i++) {
            Vector3d one = points[i].sub(points[0], new Vector3d());
            Vector3d next = points[(i + 1) % points.length].sub(points[0], new Vector3d());
            normal.add(one.cross(next));
        }
        // Without area any plane serves: the triangles are dropped as degenerate.
        return normal.length() > 0 ? normal.normalize() : new Vector3d(0, 0, 1);
    }

    private int[] cut() {
        IntStream.range(0, previous.length).forEach(this::updateReflex);
        IntStream.range(0, previous.length).forEach(this::updateEar);
        IntBuffer triangles = IntBuffer.allocate(3 * (previous.length - 2));
        int first = 0;
        for (int remaining = previous.length; remaining > 3; remaining--) {
            int tip = ear(next[first], remaining);
            triangles.put(previous[tip]).put(tip).put(next[tip]);
            first = tip == first ? next[tip] : first;
            remove(tip);
        }
        return triangles.put(first).put(next[first]).put(next[next[first]]).array();
    }

    /** First ear, so that a convex polygon becomes a fan; the second corner if a self-crossing polygon has none. */
    private int ear(int second, int remaining) {
        int corner = second;
        for (int step = 0; step < remaining && !isEar[corner]; step++) {
            corner = next[corner];
        }
        return corner;
    }

    /** Only the neighbors can become ears, or cease to be. */
    private void remove(int corner) {
        int one = previous[corner];
        int other = next[corner];
        next[one] = other;
        previous[other] = one;
        isReflex[corner] = false;
        updateReflex(one);
        updateReflex(other);
        updateEar(one);
        updateEar(other);
    }

    private void updateReflex(int corner) {
        isReflex[corner] = !(turn(previous[corner], corner, next[corner]) > 0);
    }

    private void updateEar(int corner) {
        isEar[corner] = !isReflex[corner] && isEmpty(previous[corner], corner, next[corner]);
    }

    /** If any corner lies in the triangle, a reflex one does. */
    private boolean isEmpty(int one, int tip, int other) {
        for (int corner = next[other]; corner != one; corner = next[corner]) {
            if (isReflex[corner]
                    && turn(one, tip, corner) >= 0
                    && turn(tip, other, corner) >= 0
                    && turn(other, one, corner) >= 0) {
                return false;
            }
        }
        return true;
    }

    private double turn(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
}
