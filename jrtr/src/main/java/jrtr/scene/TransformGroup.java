package jrtr.scene;

import java.util.List;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/**
 * Inner node of a scene graph.
 *
 * @param transform matrix M from the children's space to the parent's, {@code M * v}; affine and invertible
 */
public record TransformGroup(Matrix4fc transform, List<Node> children) implements Node {
    /** Throws {@link IllegalArgumentException} for a matrix that is not finite, affine and invertible. */
    public TransformGroup {
        transform = new Matrix4f(transform);
        children = List.copyOf(children);
        float volume = transform.determinant3x3();
        if (!transform.isAffine() || !transform.isFinite() || volume == 0) {
            throw new IllegalArgumentException(
                    "a group's transform must be finite, affine and invertible, but it is\n" + transform);
        }
    }

    public TransformGroup(Matrix4fc transform, Node... children) {
        this(transform, List.of(children));
    }
}
