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
        // The Frobenius norm bounds the factor by which the matrix lengthens a vector, in any shear.
        float stretch = transformation.getScale(new Vector3f()).length();
        return new BoundingSphere(moved, radius * stretch);
    }
}
