package jrtr.scene;

import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/** Shape at one of its places in world space. Equal items draw equal pictures. */
public record RenderItem(Shape shape, Matrix4fc modelToWorld) {
    public RenderItem {
        modelToWorld = new Matrix4f(modelToWorld);
    }
}
