package jrtr;

import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Triangle mesh in main memory. Arrays are shared, not copied: callers must not change them. Triangles are counter-clockwise seen from
 * outside.
 *
 * @param positions 3 per vertex: x, y, z, finite
 * @param normals 3 per vertex, unit length
 * @param tangents 4 per vertex: the tangent, unit length and orthogonal to the normal, then the handedness h, 1 or -1; the bitangent is h
 *     (normal x tangent)
 * @param textureCoordinates 2 per vertex: u, v
 * @param indices 3 per triangle, of which there is at least one: vertices, from 0
 */
public record VertexData(
        float[] positions, float[] normals, float[] tangents, float[] textureCoordinates, int[] indices) {

    public int triangles() {
        return indices.length / 3;
    }

    public BoundingSphere bounds() {
        Vector3f least = new Vector3f(Float.POSITIVE_INFINITY);
        Vector3f most = new Vector3f(Float.NEGATIVE_INFINITY);
        Vector3f vertex = new Vector3f();
        for (int i = 0; i < positions.length; i += 3) {
            vertex.set(positions[i], positions[i + 1], positions[i + 2]);
            least.min(vertex);
            most.max(vertex);
        }
        Vector3f center = least.lerp(most, 0.5f);
        float radiusSquared = 0;
        for (int i = 0; i < positions.length; i += 3) {
            radiusSquared =
                    Math.max(radiusSquared, center.distanceSquared(positions[i], positions[i + 1], positions[i + 2]));
        }
        return new BoundingSphere(center, (float) Math.sqrt(radiusSquared));
    }

    /** Sphere in the shape's coordinates and units, with a radius of at least 0. */
    public record BoundingSphere(Vector3fc center, float radius) {}
}
