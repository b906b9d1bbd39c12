package sunbeam.app.scene.mesh;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import jrtr.BoundingSphere;
import org.joml.Vector3d;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.precompute.files.Checksum;

/**
 * Share of the sky that is visible from a mesh and from the ground below it, weighted by the cosine to the normal (ambient occlusion).
 * Arrays are shared, not copied.
 *
 * @param ofVertices visible share for each vertex, 0 to 1, relative to the sky on its normal's side
 * @param ofGround visible share for squares of the ground, 0 to 1, row by row from the least x and y
 */
public record SkyVisibility(float[] ofVertices, float[] ofGround) {
    /** Half the side of the square of ground with computed visibility, about the mesh's middle, in radii of the mesh. */
    public static final double GROUND_REACH = 1.6;

    /** Number of ground squares along a side. */
    public static final int GROUND_SIDE = 160;

    public static SkyVisibility of(Mesh mesh, BlobCache cache) {
        String checksum = new Checksum()
                .add(mesh.positions())
                .add(mesh.normals())
                .add(mesh.indices())
                .hex();
        int bytes = Float.BYTES * (mesh.vertices() + GROUND_SIDE * GROUND_SIDE);
        FloatBuffer all = ByteBuffer.wrap(cache.get(
                        "sky over mesh " + checksum, bytes, () -> compute(mesh).toBytes(bytes)))
                .asFloatBuffer();
        SkyVisibility visibility = new SkyVisibility(new float[mesh.vertices()], new float[GROUND_SIDE * GROUND_SIDE]);
        all.get(visibility.ofVertices).get(visibility.ofGround);
        return visibility;
    }

    private static SkyVisibility compute(Mesh mesh) {
        BoundingSphere bounds = mesh.toVertexData().bounds();
        return new SkyDepthMaps(mesh, new Vector3d(bounds.center()), bounds.radius()).visibility();
    }

    private byte[] toBytes(int length) {
        ByteBuffer bytes = ByteBuffer.allocate(length);
        bytes.asFloatBuffer().put(ofVertices).put(ofGround);
        return bytes.array();
    }

    /** Returns the height of the ground on which a mesh lies: its least z, meters. */
    public static double ground(Mesh mesh) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 2; i < mesh.positions().length; i += 3) {
            lowest = Math.min(lowest, mesh.positions()[i]);
        }
        return lowest;
    }
}
