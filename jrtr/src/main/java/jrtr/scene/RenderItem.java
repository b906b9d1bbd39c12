package jrtr.scene;

import jrtr.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/**
 * A shape at its place.
 *
 * @param shape what
 * @param modelToWorld where; affine, copied
 */
public record RenderItem(Shape shape, Matrix4fc modelToWorld) {

    /** Copies the matrix. */
    public RenderItem {
        modelToWorld = new Matrix4f(modelToWorld);
    }

    /** A sphere in world space that holds the shape. */
    public BoundingSphere bounds() {
        return shape.vertices().bounds().transformed(modelToWorld);
    }
}
