package sunbeam.app.scene.mesh;

import java.util.List;
import org.joml.Vector3d;
import sunbeam.app.files.input.InputException;
import sunbeam.precompute.text.Quoted;

/** Built-in meshes, generated deterministically. */
public final class BuiltInMeshes {
    private BuiltInMeshes() {}

    /** Returns the names, in the order in which help shows them. */
    public static List<String> names() {
        return List.of("snake", "plane", "sphere", "cylinder");
    }

    /**
     * Generates a mesh.
     *
     * <ul>
     * <li>{@code snake}: see {@link SnakeMesh}
     * <li>{@code plane}: a square with sides of 0.2 m in z = 0 about the origin
     * <li>{@code sphere}: a sphere of radius 0.1 m about the origin
     * <li>{@code cylinder}: a cylinder without caps of radius 0.1 m about the z axis, from z = 0 to 0.2 m
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
            default ->
                throw new InputException("there is no built-in mesh " + Quoted.of(name) + "; choose one of "
                        + String.join(", ", names()));
        };
    }

    /** Generates a square in z = 0 about the origin, facing up; u along x, v along y. */
    static Mesh plane(double side, int cells) {
        return new MeshBuilder()
                .grid(
                        cells,
                        cells,
                        (u, v) -> new MeshBuilder.Point(
                                new Vector3d((u - 0.5) * side, (v - 0.5) * side, 0),
                                new Vector3d(0, 0, 1),
                                new Vector3d(1, 0, 0)))
                .build(false);
    }

    /**
     * Generates a sphere about the origin; u to the east, v from the south to the north pole. At the poles each triangle has its own
     * vertex, because east is ambiguous there.
     */
    static Mesh sphere(double radius, int columns, int rows) {
        MeshBuilder builder = new MeshBuilder().grid(columns, rows, (u, v) -> {
            double angle = angle(u);
            // Exact at the poles, where the sine of a rounded pi would leave a tiny ring.
            double across = v == 0 || v == 1 ? 0 : Math.sin(Math.PI * v);
            Vector3d normal = new Vector3d(across * Math.cos(angle), across * Math.sin(angle), -Math.cos(Math.PI * v));
            return new MeshBuilder.Point(
                    new Vector3d(normal).mul(radius), normal, new Vector3d(-Math.sin(angle), Math.cos(angle), 0));
        });
        return builder.build(true);
    }

    /** Generates an open cylinder about the z axis, from z = 0 upwards; u around, v upwards. */
    static Mesh cylinder(double radius, double height, int columns, int rows) {
        MeshBuilder builder = new MeshBuilder().grid(columns, rows, (u, v) -> {
            double angle = angle(u);
            Vector3d normal = new Vector3d(Math.cos(angle), Math.sin(angle), 0);
            return new MeshBuilder.Point(
                    new Vector3d(normal).mul(radius).add(0, 0, v * height),
                    normal,
                    new Vector3d(-Math.sin(angle), Math.cos(angle), 0));
        });
        return builder.build(false);
    }

    /** Returns the angle at u, radians; 0 also at u = 1, so that both sides of the seam have bitwise equal points. */
    private static double angle(double u) {
        return u == 1 ? 0 : 2 * Math.PI * u;
    }
}
