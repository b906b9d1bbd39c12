package sunbeam.app.scene.mesh;

import org.joml.Vector3d;

/** Triangles without area: they have no normal and cannot be seen. */
final class DegenerateTriangles {
    // Height over longest side below which float32 positions do not tell a triangle from a line.
    private static final double THINNEST = 1e-9;

    private DegenerateTriangles() {}

    static RawMesh dropped(RawMesh mesh) {
        IntList kept = new IntList();
        for (int first = 0; first < mesh.cornerCount(); first += 3) {
            if (!isDegenerate(mesh, first)) {
                for (int i = 3 * first; i < 3 * first + 9; i++) {
                    kept.add(mesh.corners()[i]);
                }
            }
        }
        return new RawMesh(mesh.positions(), mesh.textureCoordinates(), mesh.normals(), kept.toArray());
    }

    private static boolean isDegenerate(RawMesh mesh, int first) {
        Vector3d a = mesh.positionOf(first);
        Vector3d b = mesh.positionOf(first + 1);
        Vector3d c = mesh.positionOf(first + 2);
        double longest = Math.max(a.distanceSquared(b), Math.max(b.distanceSquared(c), c.distanceSquared(a)));
        return mesh.areaNormal(first).length() <= THINNEST * longest;
    }
}
