package sunbeam.app.scene.mesh;

import org.joml.Vector3d;
import sunbeam.app.scene.mesh.format.RawMesh;

/**
 * Unit normals of corners: the file's, or where it has none (or one of length 0) the mean of the triangles about the
 * position, weighted by area.
 */
final class CornerNormals {
    private final RawMesh mesh;
    private final float[] sums;

    CornerNormals(RawMesh mesh) {
        this.mesh = mesh;
        this.sums = new float[mesh.positions().length];
        for (int first = 0; first < mesh.cornerCount(); first += 3) {
            Vector3d normal = mesh.areaNormal(first);
            for (int corner = first; corner < first + 3; corner++) {
                int at = 3 * mesh.position(corner);
                sums[at] += (float) normal.x;
                sums[at + 1] += (float) normal.y;
                sums[at + 2] += (float) normal.z;
            }
        }
    }

    /** What corners of one position must have in common to share a normal: the file's index, -1 for the mean, or less. */
    int key(int corner) {
        int given = mesh.normal(corner);
        if (given >= 0 && RawMesh.vector(mesh.normals(), given).length() > 0) {
            return given;
        }
        Vector3d mean = RawMesh.vector(sums, mesh.position(corner));
        Vector3d own = mesh.areaNormal(corner - corner % 3);
        // Triangles back to back cancel or leave the mean to one side; the others keep their own normal.
        return mean.dot(own) > 1e-6 * mean.length() * own.length() ? -1 : -2 - corner / 3;
    }

    /** The unit normal of the corners of a position with this key. */
    Vector3d normal(int position, int key) {
        if (key >= 0) {
            return RawMesh.vector(mesh.normals(), key).normalize();
        }
        Vector3d normal = key == -1 ? RawMesh.vector(sums, position) : mesh.areaNormal(3 * (-2 - key));
        return normal.normalize();
    }
}
