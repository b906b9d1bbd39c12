package sunbeam.app.scene.mesh;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import jrtr.BoundingSphere;
import org.joml.Vector3d;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.precompute.files.Checksum;

/**
 * Share of the sky that is visible from a mesh and from the ground below it, weighted by the cosine (ambient occlusion). Arrays are shared,
 * not copied.
 *
 * @param ofVertices of each vertex, 0 to 1, relative to its normal's hemisphere
 * @param ofGround of squares of the ground, 0 to 1, row by row from the least x and y
 */
public record SkyVisibility(float[] ofVertices, float[] ofGround) {
    /** Extent of the computed ground from the mesh's middle, in radii of the mesh. */
    public static final double GROUND_REACH = 1.6;

    /** Points of the ground along a side. */
    public static final int GROUND_SIDE = 160;

    /**
     * Computes the visibility of the sky from a mesh and the ground below it.
     *
     * @param kept cache of results
     */
    public static SkyVisibility of(Mesh mesh, BlobCache kept) {
        String checksum = new Checksum()
                .add(mesh.positions())
                .add(mesh.normals())
                .add(mesh.indices())
                .hex();
        int bytes = Float.BYTES * (mesh.vertices() + GROUND_SIDE * GROUND_SIDE);
        FloatBuffer all = ByteBuffer.wrap(kept.get(
                        "sky over mesh " + checksum, bytes, () -> look(mesh).toBytes(bytes)))
                .asFloatBuffer();
        SkyVisibility seen = new SkyVisibility(new float[mesh.vertices()], new float[GROUND_SIDE * GROUND_SIDE]);
        all.get(seen.ofVertices).get(seen.ofGround);
        return seen;
    }

    private static SkyVisibility look(Mesh mesh) {
        BoundingSphere bounds = mesh.toVertexData().bounds();
        return new SkyDepthMaps(mesh, new Vector3d(bounds.center()), bounds.radius()).seen();
    }

    private byte[] toBytes(int length) {
        ByteBuffer bytes = ByteBuffer.allocate(length);
        bytes.asFloatBuffer().put(ofVertices).put(ofGround);
        return bytes.array();
    }

    /** Height of the ground on which a mesh lies. */
    public static double ground(Mesh mesh) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 2; i < mesh.positions().length; i += 3) {
            lowest = Math.min(lowest, mesh.positions()[i]);
        }
        return lowest;
    }
}
