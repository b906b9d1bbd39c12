package sunbeam.app.scene.mesh;

import org.joml.Vector3d;

/** Plane, sphere and cylinder. */
final class SimpleMeshes {
    private SimpleMeshes() {}

    /** A square in z = 0 about the origin, seen from above; u along x, v along y. */
    static Mesh plane(double side, int cells) {
        MeshBuilder builder = new MeshBuilder();
        GridMesh.add(
                builder,
                cells,
                cells,
                (u, v) -> new GridMesh.Point(
                        new Vector3d((u - 0.5) * side, (v - 0.5) * side, 0),
                        new Vector3d(0, 0, 1),
                        new Vector3d(1, 0, 0)));
        return builder.build(false);
    }

    /**
     * A sphere about the origin; u to the east, v from the south to the north pole. At the poles, where all directions
     * are east, each triangle has a vertex of its own.
     */
    static Mesh sphere(double radius, int columns, int rows) {
        MeshBuilder builder = new MeshBuilder();
        GridMesh.add(builder, columns, rows, (u, v) -> {
            double turn = turn(u);
            // Exact at the poles, where the sine of a rounded pi would leave a tiny ring.
            double across = v == 0 || v == 1 ? 0 : Math.sin(Math.PI * v);
            Vector3d normal = new Vector3d(across * Math.cos(turn), across * Math.sin(turn), -Math.cos(Math.PI * v));
            return new GridMesh.Point(
                    new Vector3d(normal).mul(radius), normal, new Vector3d(-Math.sin(turn), Math.cos(turn), 0));
        });
        return builder.build(true);
    }

    /**
     * An open cylinder's mantle about the z axis, from z = 0 upwards; u around, v upwards. Without lids: light and eye see
     * the mantle from outside.
     */
    static Mesh cylinder(double radius, double height, int columns, int rows) {
        MeshBuilder builder = new MeshBuilder();
        GridMesh.add(builder, columns, rows, (u, v) -> {
            double turn = turn(u);
            Vector3d normal = new Vector3d(Math.cos(turn), Math.sin(turn), 0);
            return new GridMesh.Point(
                    new Vector3d(normal).mul(radius).add(0, 0, v * height),
                    normal,
                    new Vector3d(-Math.sin(turn), Math.cos(turn), 0));
        });
        return builder.build(false);
    }

    /** The seam's two sides are the same points to the last bit. */
    private static double turn(double u) {
        return u == 1 ? 0 : 2 * Math.PI * u;
    }
}
