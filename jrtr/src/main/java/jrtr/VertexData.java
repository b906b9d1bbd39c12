package jrtr;

import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Triangle mesh in main memory. Arrays are shared, not copied: callers must not change them. Triangles are counter-clockwise seen from
 * outside.
 *
 * @param positions 3 per vertex: x, y, z
 * @param normals 3 per vertex, unit length
 * @param tangents 4 per vertex: the tangent, unit length and orthogonal to the normal, then the handedness h, 1 or -1; the bitangent is h
 *     (normal x tangent)
 * @param textureCoordinates 2 per vertex: u, v
 * @param indices 3 per triangle: vertices, from 0
 */
public record VertexData(
        float[] positions, float[] normals, float[] tangents, float[] textureCoordinates, int[] indices) {

    public VertexData {
        int vertices = positions.length / 3;
        requireLength("positions", positions.length, 3 * vertices);
        requireLength("normals", normals.length, 3 * vertices);
        requireLength("tangents", tangents.length, 4 * vertices);
        requireLength("textureCoordinates", textureCoordinates.length, 2 * vertices);
        requireLength("indices", indices.length, indices.length / 3 * 3);
        if (indices.length == 0) {
            throw new IllegalArgumentException("vertex data without a triangle");
        }
        for (int index : indices) {
            if (index < 0 || index >= vertices) {
                throw new IllegalArgumentException("index " + index + " is out of range for " + vertices + " vertices");
            }
        }
        for (float coordinate : positions) {
            if (!Float.isFinite(coordinate)) {
                throw new IllegalArgumentException("vertex data has a position of " + coordinate);
            }
        }
    }

    private static void requireLength(String name, int length, int expected) {
        if (length != expected) {
            throw new IllegalArgumentException(
                    "vertex data's " + name + " have " + length + " numbers, not " + expected);
        }
    }

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
