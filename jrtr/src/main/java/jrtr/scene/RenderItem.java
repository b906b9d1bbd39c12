package jrtr.scene;

import jrtr.VertexData.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/** Shape at one of its places in world space. Equal items draw equal pictures. */
public record RenderItem(Shape shape, Matrix4fc modelToWorld) {
    public RenderItem {
        modelToWorld = new Matrix4f(modelToWorld);
    }

    /** Returns a sphere around the shape in world space. */
    public BoundingSphere bounds() {
        return shape.mesh().bounds().transformed(modelToWorld);
    }
}
