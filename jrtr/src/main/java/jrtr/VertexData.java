package jrtr;

import org.joml.Matrix3f;
import org.joml.Matrix4fc;
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
    public record BoundingSphere(Vector3fc center, float radius) {
        /** Returns a sphere around this one in another space, to which an affine matrix leads. */
        public BoundingSphere transformed(Matrix4fc matrix) {
            boolean isRigid = (matrix.properties() & Matrix4fc.PROPERTY_ORTHONORMAL) != 0;
            return new BoundingSphere(
                    matrix.transformPosition(center, new Vector3f()), isRigid ? radius : radius * stretch(matrix));
        }

        /** Returns a bound of the factor by which a matrix lengthens vectors, exact if it scales along the axes before a rotation. */
        private static float stretch(Matrix4fc matrix) {
            Matrix3f linear = matrix.get3x3(new Matrix3f());
            // The largest eigenvalue of the product is the factor's square; no row's sum of magnitudes is less.
            Matrix3f square = linear.transpose(new Matrix3f()).mul(linear);
            float most = 0;
            for (int row = 0; row < 3; row++) {
                most = Math.max(
                        most,
                        Math.abs(square.get(0, row)) + Math.abs(square.get(1, row)) + Math.abs(square.get(2, row)));
            }
            return (float) Math.sqrt(most);
        }

        /** Returns the smallest sphere around this one and another. */
        public BoundingSphere with(BoundingSphere other) {
            float distance = center.distance(other.center);
            if (distance + other.radius <= radius) {
                return this;
            }
            if (distance + radius <= other.radius) {
                return other;
            }
            float around = 0.5f * (distance + radius + other.radius);
            return new BoundingSphere(center.lerp(other.center, (around - radius) / distance, new Vector3f()), around);
        }
    }
}
