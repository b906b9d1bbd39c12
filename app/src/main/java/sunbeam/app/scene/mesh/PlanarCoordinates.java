package sunbeam.app.scene.mesh;

/**
 * Texture coordinates for meshes that have none: the view from above, x to u and y to v, scaled alike so that the longer
 * side of the mesh spans 0 to 1. Tangents then follow x.
 */
final class PlanarCoordinates {
    private PlanarCoordinates() {}

    static RawMesh added(RawMesh mesh) {
        double[] least = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] most = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int corner = 0; corner < mesh.cornerCount(); corner++) {
            for (int i = 0; i < 2; i++) {
                double value = mesh.positions()[3 * mesh.position(corner) + i];
                least[i] = Math.min(least[i], value);
                most[i] = Math.max(most[i], value);
            }
        }
        double side = Math.max(most[0] - least[0], most[1] - least[1]);
        // A mesh upright on one line of the ground has all its texture on one line too.
        double scale = side > 0 ? 1 / side : 1;
        int count = mesh.positions().length / 3;
        float[] coordinates = new float[2 * count];
        for (int position = 0; position < count; position++) {
            for (int i = 0; i < 2; i++) {
                coordinates[2 * position + i] = (float) ((mesh.positions()[3 * position + i] - least[i]) * scale);
            }
        }
        int[] corners = mesh.corners().clone();
        for (int corner = 0; corner < mesh.cornerCount(); corner++) {
            corners[3 * corner + 1] = mesh.position(corner);
        }
        return new RawMesh(mesh.positions(), coordinates, mesh.normals(), corners);
    }
}
