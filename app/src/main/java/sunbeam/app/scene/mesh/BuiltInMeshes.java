package sunbeam.app.scene.mesh;

import java.util.List;
import java.util.function.DoubleFunction;
import org.joml.Vector3d;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Quoted;

/** Built-in meshes, generated deterministically. */
public final class BuiltInMeshes {
    private BuiltInMeshes() {}

    public static List<String> names() {
        return List.of("snake", "plane", "sphere", "cylinder", "disc");
    }

    /**
     * Generates a mesh.
     *
     * <ul>
     * <li>{@code snake}: see {@link SnakeMesh}
     * <li>{@code plane}: a square with sides of 0.2 m in z = 0 about the origin
     * <li>{@code sphere}: a sphere of radius 0.1 m about the origin
     * <li>{@code cylinder}: a cylinder without caps of radius 0.1 m about the z axis, from z = 0 to 0.2 m
     * <li>{@code disc}: the coated ring of a compact disc, which lies on z = 0; tangents along the tracks
     * </ul>
     *
     * @throws InputException for any other name
     */
    public static Mesh create(String name) {
        return switch (name) {
            case "snake" -> SnakeMesh.create();
            case "plane" -> plane(0.2, 8);
            case "sphere" -> sphere(0.1, 96, 48);
            case "cylinder" -> cylinder(0.1, 0.2, 96, 24);
            case "disc" -> disc(256, 16);
            default ->
                throw new InputException("there is no built-in mesh " + Quoted.of(name) + "; choose one of "
                        + String.join(", ", names()));
        };
    }

    /** Faces up; u along x, v along y. */
    static Mesh plane(double side, int cells) {
        return new Mesh.Builder()
                .grid(
                        cells,
                        cells,
                        (u, v) -> new Mesh.Builder.Point(
                                new Vector3d((u - 0.5) * side, (v - 0.5) * side, 0),
                                new Vector3d(0, 0, 1),
                                new Vector3d(1, 0, 0)))
                .build(false);
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

    /** From z = 0 upwards about the z axis; u around, v upwards. */
    static Mesh cylinder(double radius, double height, int columns, int rows) {
        return revolution(columns, rows, false, v -> new Profile(radius, v * height, 1, 0));
    }

    /**
     * Generates the coated ring of a compact disc (radii of 20 and 59 mm) on z = 0, with round edges and without bottom; u along the
     * tracks, v inwards.
     */
    private static Mesh disc(int columns, int rows) {
        double edge = 1.2e-3;
        return revolution(columns, rows, false, v -> {
            // Each edge takes a quarter of v, the flat side the rest.
            double flat = Math.min(1, Math.max(0, 2 * v - 0.5));
            double turn = Math.PI * (0.5 - 2 * (v - flat / 2));
            double outward = Math.sin(turn);
            double upward = Math.cos(turn);
            double middle = 0.059 - edge - (0.039 - 2 * edge) * flat;
            return new Profile(middle + edge * outward, edge * upward, outward, upward);
        });
    }

    /** Point in meters, and its unit normal away from the axis and along it. */
    private record Profile(double radius, double height, double outward, double upward) {}

    /** Turns a profile over v about the z axis; u turns counter-clockwise. */
    private static Mesh revolution(int columns, int rows, boolean closed, DoubleFunction<Profile> profile) {
        Mesh.Builder builder = new Mesh.Builder().grid(columns, rows, (u, v) -> {
            // Both sides of the seam have bitwise equal points.
            double angle = u == 1 ? 0 : 2 * Math.PI * u;
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            Profile at = profile.apply(v);
            return new Mesh.Builder.Point(
                    new Vector3d(at.radius * cos, at.radius * sin, at.height),
                    new Vector3d(at.outward * cos, at.outward * sin, at.upward),
                    new Vector3d(-sin, cos, 0));
        });
        return builder.build(closed);
    }
}
