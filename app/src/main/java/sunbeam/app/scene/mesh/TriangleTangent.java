package sunbeam.app.scene.mesh;

import org.joml.Vector3d;

/**
 * How a triangle's texture lies on it.
 *
 * @param along vector in which the texture's u grows (Lengyel 2001), as long as twice the triangle's area; zero where the
 *     texture has no area
 * @param mirrored whether the texture is seen mirrored from outside
 */
record TriangleTangent(Vector3d along, boolean mirrored) {

    /** Of the triangle that begins at a corner. */
    static TriangleTangent of(RawMesh mesh, int first) {
        float[] uv = mesh.textureCoordinates();
        int a = 2 * mesh.textureCoordinate(first);
        int b = 2 * mesh.textureCoordinate(first + 1);
        int c = 2 * mesh.textureCoordinate(first + 2);
        double u1 = (double) uv[b] - uv[a];
        double v1 = (double) uv[b + 1] - uv[a + 1];
        double u2 = (double) uv[c] - uv[a];
        double v2 = (double) uv[c + 1] - uv[a + 1];
        double area = u1 * v2 - u2 * v1;
        double size = (Math.abs(u1) + Math.abs(u2)) * (Math.abs(v1) + Math.abs(v2));
        // Float32 texture coordinates do not tell thinner triangles from lines.
        if (Math.abs(area) <= 1e-9 * size) {
            return new TriangleTangent(new Vector3d(), false);
        }
        Vector3d origin = mesh.positionOf(first);
        Vector3d edge1 = mesh.positionOf(first + 1).sub(origin);
        Vector3d edge2 = mesh.positionOf(first + 2).sub(origin);
        Vector3d along = edge1.mul(v2).sub(edge2.mul(v1)).mul(Math.signum(area));
        double length = along.length();
        if (length == 0) {
            return new TriangleTangent(new Vector3d(), false);
        }
        return new TriangleTangent(along.mul(mesh.areaNormal(first).length() / length), area < 0);
    }
}
