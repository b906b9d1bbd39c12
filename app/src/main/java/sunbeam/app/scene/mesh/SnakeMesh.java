package sunbeam.app.scene.mesh;

import java.util.Arrays;
import org.joml.Vector3d;

/**
 * The built-in snake: a coiled body 1.1 m long on z = 0, about 14,000 vertices and 27,000 triangles. Texture coordinate u runs from the
 * snout (0) to the tip of the tail (1), equally from scale to scale ({@link SnakeBody}); v around the body, from the belly (0) over the
 * back (0.5), proportional to the angle. Tangents, which direct the nanostructure, follow the body towards the tail.
 */
public final class SnakeMesh {
    private static final int COLUMNS = 40;
    private static final int RINGS = 340;

    private final Mesh.Builder builder = new Mesh.Builder();
    private final double[] places = ringPlaces();

    private SnakeMesh() {}

    public static Mesh create() {
        SnakeMesh snake = new SnakeMesh();
        int[][] rings = new int[RINGS][];
        Arrays.setAll(rings, ring -> snake.ring(ring));
        for (int ring = 0; ring + 1 < RINGS; ring++) {
            snake.join(rings[ring], rings[ring + 1]);
        }
        snake.closeSnout(rings[0]);
        snake.closeTail(rings[RINGS - 1]);
        return snake.builder.build(true);
    }

    /** Returns the rings' places: closer where the body is thin, so that scales keep their shape; closest on the head. */
    private double[] ringPlaces() {
        int samples = 20_000;
        double[] weight = new double[samples + 1];
        for (int i = 1; i <= samples; i++) {
            double place = (i - 0.5) / samples;
            double relative = SnakeBody.halfWidth(place) / SnakeBody.RADIUS;
            double spacing = 0.3 + 0.7 * relative;
            weight[i] = weight[i - 1] + 1 / spacing + (place < SnakeBody.NECK ? 5 : 0);
        }
        double[] result = new double[RINGS];
        int at = 0;
        for (int ring = 0; ring < RINGS; ring++) {
            double wanted = weight[samples] * (ring + 0.35) / (RINGS - 0.3);
            while (weight[at + 1] < wanted) {
                at++;
            }
            result[ring] = (at + (wanted - weight[at]) / (weight[at + 1] - weight[at])) / samples;
        }
        return result;
    }

    /** Radians from the belly; columns are closer on the visible back. */
    private static double angle(double column) {
        double turn = 2 * Math.PI * column / COLUMNS;
        return turn + 0.3 * Math.sin(turn);
    }

    /** Adds a ring with a seam of v = 0 and v = 1 under the belly. */
    private int[] ring(int ring) {
        int[] vertices = new int[COLUMNS + 1];
        double place = places[ring];
        for (int column = 0; column <= COLUMNS; column++) {
            // Both sides of the seam have bitwise equal points.
            double angle = angle(column % COLUMNS);
            Mesh.Builder.Point frame = SnakeBody.frame(place, angle);
            double v = angle(column) / (2 * Math.PI);
            vertices[column] = builder.vertex(frame, SnakeBody.u(place), v);
        }
        return vertices;
    }

    private static Vector3d orthogonal(Vector3d vector, Vector3d normal) {
        return new Vector3d(vector).fma(-vector.dot(normal), normal).normalize();
    }

    private void join(int[] first, int[] second) {
        for (int column = 0; column < COLUMNS; column++) {
            int a = first[column];
            int b = first[column + 1];
            int c = second[column + 1];
            int d = second[column];
            builder.triangle(a, d, c);
            builder.triangle(a, c, b);
        }
    }

    /** Each triangle has its own vertex at the tip, whose tangent points towards the triangle. */
    private void closeSnout(int[] ring) {
        Vector3d forwards = SnakeBody.direction(0).negate();
        Vector3d tip = SnakeBody.point(0, 0);
        for (int column = 0; column < COLUMNS; column++) {
            double angle = angle(column + 0.5);
            Vector3d outward = SnakeBody.point(places[0], angle).sub(tip);
            int vertex = builder.vertex(
                    new Mesh.Builder.Point(tip, forwards, orthogonal(outward, forwards)), 0, angle / (2 * Math.PI));
            builder.triangle(ring[column], ring[column + 1], vertex);
        }
    }

    /** Each triangle has its own vertex at the tip, with the normal of its side of the cone. */
    private void closeTail(int[] ring) {
        Vector3d tip = SnakeBody.point(1, 0);
        for (int column = 0; column < COLUMNS; column++) {
            double angle = angle(column + 0.5);
            Mesh.Builder.Point side = SnakeBody.frame(places[RINGS - 1], angle);
            int vertex = builder.vertex(
                    new Mesh.Builder.Point(tip, side.normal(), side.tangent()), 1, angle / (2 * Math.PI));
            builder.triangle(ring[column], vertex, ring[column + 1]);
        }
    }
}
