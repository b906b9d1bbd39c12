package sunbeam.app.scene.mesh;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import org.joml.Vector3d;

/** Built-in meshes, generated deterministically. */
public final class BuiltInMeshes {
    private BuiltInMeshes() {}

    public static List<String> names() {
        return List.of("snake", "plane", "sphere", "ellipsoid", "cylinder", "disc");
    }

    public static Mesh create(String name) {
        return switch (name) {
            case "snake" -> Snake.create();
            case "plane" -> plane(0.2, 8);
            case "sphere" -> sphere(0.1, 96, 48);
            case "ellipsoid" -> ellipsoid(0.1, 0.065, 0.045, 96, 48);
            case "cylinder" -> cylinder(0.1, 0.2, 96, 24);
            case "disc" -> disc(256);
            default -> throw new IllegalArgumentException(name);
        };
    }

    /** Faces up; u along x, v along y. */
    static Mesh plane(double side, int cells) {
        return Mesh.Builder.grid(cells, cells, false, (u, v) -> {
            Vector3d place = new Vector3d((u - 0.5) * side, (v - 0.5) * side, 0);
            return new Mesh.Builder.Point(place, new Vector3d(0, 0, 1), new Vector3d(1, 0, 0));
        });
    }

    /**
     * Generates a sphere; u to the east, v from south to north. At the poles, where east is ambiguous, each triangle has its own vertex.
     */
    static Mesh sphere(double radius, int columns, int rows) {
        return revolution(columns, rows, true, v -> {
            // The sine of a rounded pi would leave a tiny ring.
            double outward = v == 0 || v == 1 ? 0 : Math.sin(Math.PI * v);
            double upward = -Math.cos(Math.PI * v);
            return new Profile(radius * outward, radius * upward, outward, upward);
        });
    }

    /** A sphere, stretched along each axis. */
    private static Mesh ellipsoid(double halfX, double halfY, double halfZ, int columns, int rows) {
        return Mesh.Builder.grid(columns, rows, true, (u, v) -> {
            // Both sides of the seam have bitwise equal points.
            double angle = u == 1 ? 0 : 2 * Math.PI * u;
            double outward = v == 0 || v == 1 ? 0 : Math.sin(Math.PI * v);
            Vector3d unit = new Vector3d(outward * Math.cos(angle), outward * Math.sin(angle), -Math.cos(Math.PI * v));
            Vector3d place = new Vector3d(halfX * unit.x, halfY * unit.y, halfZ * unit.z);
            Vector3d normal = new Vector3d(unit.x / halfX, unit.y / halfY, unit.z / halfZ).normalize();
            Vector3d east = new Vector3d(-halfX * Math.sin(angle), halfY * Math.cos(angle), 0).normalize();
            return new Mesh.Builder.Point(place, normal, east);
        });
    }

    /** From z = 0 upwards about the z axis; u around, v upwards. */
    static Mesh cylinder(double radius, double height, int columns, int rows) {
        return revolution(columns, rows, false, v -> new Profile(radius, v * height, 1, 0));
    }

    /**
     * Generates the opaque parts of a compact disc of 12 cm: the ring with tracks, from a radius of 23 mm on, the stacking ring in the clear
     * hub, and the edge of the hole of 15 mm. u runs along the tracks, v inwards.
     */
    private static Mesh disc(int columns) {
        Mesh.Builder disc = new Mesh.Builder();
        disc.grid(columns, 16, 0, 0.9, round(v -> ring(0.059, 0.023, 1.2e-3, v / 0.9)));
        disc.grid(columns, 8, 0.9, 0.95, round(v -> ring(0.0177, 0.0167, 5e-4, (v - 0.9) / 0.05)));
        disc.grid(columns, 8, 0.95, 1, round(v -> ring(0.0081, 0.0075, 3e-4, (v - 0.95) / 0.05)));
        return disc.build(false);
    }

    /** Upper side of a flat ring with round edges, from its outer (v = 0) to its inner radius (v = 1). */
    private static Profile ring(double outer, double inner, double edge, double v) {
        // Each edge takes a quarter of v, the flat side the rest; without one, the edges take all.
        boolean isFlat = outer - inner > 2.001 * edge;
        double flat = isFlat ? Math.min(1, Math.max(0, 2 * v - 0.5)) : v;
        double turn = Math.PI * (0.5 - 2 * (v - flat / 2));
        double outward = Math.sin(turn);
        double upward = Math.cos(turn);
        double middle = outer - edge - (outer - inner - 2 * edge) * flat;
        return new Profile(middle + edge * outward, edge * upward, outward, upward);
    }

    /** Point in meters, and its unit normal away from the axis and along it. */
    private record Profile(double radius, double height, double outward, double upward) {}

    private static Mesh revolution(int columns, int rows, boolean closed, DoubleFunction<Profile> profile) {
        return Mesh.Builder.grid(columns, rows, closed, round(profile));
    }

    /** Turns a profile over v about the z axis; u turns counter-clockwise. */
    private static Mesh.Builder.Surface round(DoubleFunction<Profile> profile) {
        return (u, v) -> {
            // Both sides of the seam have bitwise equal points.
            double angle = u == 1 ? 0 : 2 * Math.PI * u;
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            Profile at = profile.apply(v);
            Vector3d place = new Vector3d(at.radius * cos, at.radius * sin, at.height);
            Vector3d normal = new Vector3d(at.outward * cos, at.outward * sin, at.upward);
            return new Mesh.Builder.Point(place, normal, new Vector3d(-sin, cos, 0));
        };
    }

    /**
     * The built-in snake: a coiled body 1.1 m long on z = 0, about 14,000 vertices and 27,000 triangles. Texture coordinate u runs from the
     * snout (0) to the tip of the tail (1), equally from scale to scale ({@link SnakeBody}); v around the body, from the belly (0) over the
     * back (0.5), proportional to the angle. Tangents, which direct the nanostructure, follow the body towards the tail.
     */
    private static final class Snake {
        private static final int COLUMNS = 40;
        private static final int RINGS = 340;

        private final Mesh.Builder builder = new Mesh.Builder();
        private final double[] places = ringPlaces();

        static Mesh create() {
            Snake snake = new Snake();
            int[][] rings = new int[RINGS][];
            Arrays.setAll(rings, ring -> snake.ring(ring));
            for (int ring = 0; ring + 1 < RINGS; ring++) {
                int[] first = rings[ring];
                int[] second = rings[ring + 1];
                for (int column = 0; column < COLUMNS; column++) {
                    snake.builder.triangle(first[column], second[column], second[column + 1]);
                    snake.builder.triangle(first[column], second[column + 1], first[column + 1]);
                }
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
                double spacing = 0.3 + 0.7 * (SnakeBody.halfWidth(place) / SnakeBody.RADIUS);
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
                vertices[column] = builder.vertex(frame, SnakeBody.u(place), angle(column) / (2 * Math.PI));
            }
            return vertices;
        }

        /** Each triangle has its own vertex at the tip, whose tangent points towards the triangle. */
        private void closeSnout(int[] ring) {
            Vector3d forwards = SnakeBody.direction(0).negate();
            Vector3d tip = SnakeBody.point(0, 0);
            for (int column = 0; column < COLUMNS; column++) {
                double angle = angle(column + 0.5);
                Vector3d outward = SnakeBody.point(places[0], angle).sub(tip);
                Vector3d tangent = outward.fma(-outward.dot(forwards), forwards).normalize();
                int vertex = builder.vertex(new Mesh.Builder.Point(tip, forwards, tangent), 0, angle / (2 * Math.PI));
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
}
