package jrtr;

import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Sphere that encloses a shape.
 *
 * @param center center in the shape's coordinates; copied
 * @param radius in the shape's units, at least 0
 */
public record BoundingSphere(Vector3fc center, float radius) {

    public BoundingSphere {
        center = new Vector3f(center);
        if (!(radius >= 0) || Float.isInfinite(radius)) {
            throw new IllegalArgumentException("bounding sphere's radius " + radius + " is not a length");
        }
    }

    /** Returns a sphere that encloses this one after an affine transformation. */
    public BoundingSphere transformed(Matrix4fc transformation) {
        Vector3f moved = transformation.transformPosition(center, new Vector3f());
        return new BoundingSphere(moved, radius * stretch(transformation));
    }

    /**
     * Returns an upper bound of the factor by which the matrix lengthens a vector: the exact one if its columns are orthogonal (rotation
     * and scaling), else the Frobenius norm.
     */
    private static float stretch(Matrix4fc m) {
        Vector3f x = new Vector3f(m.m00(), m.m01(), m.m02());
        Vector3f y = new Vector3f(m.m10(), m.m11(), m.m12());
        Vector3f z = new Vector3f(m.m20(), m.m21(), m.m22());
        float sum = x.lengthSquared() + y.lengthSquared() + z.lengthSquared();
        float skew = Math.max(Math.abs(x.dot(y)), Math.max(Math.abs(y.dot(z)), Math.abs(z.dot(x))));
        // Rounded columns of a rotation are orthogonal to about 1e-6. The factor 1.0001 covers columns that are less
        // orthogonal but pass this test.
        if (skew <= 1e-5f * sum) {
            return 1.0001f * Math.max(x.length(), Math.max(y.length(), z.length()));
        }
        return (float) Math.sqrt(sum);
    }
}
