package sunbeam.app.scene.mesh;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import sunbeam.app.scene.mesh.format.RawMesh;

/**
 * Unit normals of corners. The file's normal is used if it has one of length above 0, else the mean of the normals of the triangles around
 * the position, weighted by area. A file may repeat a position, at seams of textures and at hard edges. Each copy of the position has its
 * own mean; the mean over all copies replaces it if the angle between the two is small.
 */
final class CornerNormals {
    // Cosine of the largest angle, 41 degrees, between the mean of one copy of a position and the mean over all copies
    // that replaces it. A hard edge of 90 degrees stays hard: the mean over it is 45 degrees from either side.
    private static final double LEAST_COSINE = 0.75;

    private final RawMesh mesh;
    // Sum of triangle normals for each position, weighted by area.
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
            Vector3d own = Mesh.vector(sums, i);
            // Unit vectors: the mean must not depend on how faces are divided into triangles.
            means.computeIfAbsent(position(i), place -> new Vector3d()).fma(1 / Math.max(1e-300, own.length()), own);
        }
        for (int i = 0; i < sums.length / 3; i++) {
            Vector3d mean = means.get(position(i));
            Vector3d own = Mesh.vector(sums, i);
            if (mean.dot(own) > LEAST_COSINE * mean.length() * own.length()) {
                sums[3 * i] = (float) mean.x;
                sums[3 * i + 1] = (float) mean.y;
                sums[3 * i + 2] = (float) mean.z;
            }
        }
    }

    private Vector3d position(int i) {
        double[] all = mesh.positions();
        // Adding 0.0 turns -0.0 into 0.0: the two are equal but have different hashes.
        return new Vector3d(all[3 * i] + 0.0, all[3 * i + 1] + 0.0, all[3 * i + 2] + 0.0);
    }

    /**
     * Returns a key of a corner's normal; corners of one position with the same key have the same normal. The key is the index of the
     * file's normal, -1 for the mean around the position, or -2 - t for the normal of the corner's own triangle, number t.
     */
    int key(int corner) {
        int given = mesh.normal(corner);
        if (given >= 0 && Mesh.vector(mesh.normals(), given).length() > 0) {
            return given;
        }
        Vector3d mean = Mesh.vector(sums, mesh.position(corner));
        Vector3d own = mesh.areaNormal(corner - corner % 3);
        // Where triangles lie back to back the mean is zero or faces the back of some; these use their own normal.
        return mean.dot(own) > 1e-6 * mean.length() * own.length() ? -1 : -2 - corner / 3;
    }

    Vector3d normal(int position, int key) {
        if (key >= 0) {
            return Mesh.vector(mesh.normals(), key).normalize();
        }
        Vector3d normal = key == -1 ? Mesh.vector(sums, position) : mesh.areaNormal(3 * (-2 - key));
        return normal.normalize();
    }
}
