package sunbeam.app.scene.mesh;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import sunbeam.app.scene.mesh.format.RawMesh;

/**
 * Unit normals of corners: the file's, or if it has none (or one of length 0) the mean of the triangles around the position, weighted by
 * area. Repeated positions, at seams of textures and at hard edges, share a mean if it is near each one's own.
 */
final class CornerNormals {
    // Cosine. The mean over a hard edge of 90 degrees is 45 degrees from either side.
    private static final double NEAR = 0.75;

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
        if (IntStream.range(0, mesh.cornerCount()).anyMatch(corner -> mesh.normal(corner) < 0)) {
            shareMeans();
        }
    }

    private void shareMeans() {
        Map<Vector3d, Vector3d> means = new HashMap<>();
        for (int i = 0; i < sums.length / 3; i++) {
            Vector3d own = RawMesh.vector(sums, i);
            // Equal weights, so that the triangulation of faces does not matter across an edge.
            means.computeIfAbsent(position(i), place -> new Vector3d()).fma(1 / Math.max(1e-300, own.length()), own);
        }
        for (int i = 0; i < sums.length / 3; i++) {
            Vector3d mean = means.get(position(i));
            Vector3d own = RawMesh.vector(sums, i);
            if (mean.dot(own) > NEAR * mean.length() * own.length()) {
                sums[3 * i] = (float) mean.x;
                sums[3 * i + 1] = (float) mean.y;
                sums[3 * i + 2] = (float) mean.z;
            }
        }
    }

    private Vector3d position(int i) {
        double[] all = mesh.positions();
        // Avoids negative zeros, which are equal but have another hash.
        return new Vector3d(all[3 * i] + 0.0, all[3 * i + 1] + 0.0, all[3 * i + 2] + 0.0);
    }

    /** Key that corners of one position share with their normal: the file's index, -1 for the mean, or less for their own. */
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
