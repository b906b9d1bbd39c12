package jrtr.scene;

import java.util.List;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/**
 * Node whose children have a coordinate system of their own.
 *
 * @param toParent matrix M from the children's coordinates v to the parent's, {@code M * v}; affine; copied
 * @param children child nodes; copied
 */
public record Group(Matrix4fc toParent, List<Node> children) implements Node {
    /** @throws IllegalArgumentException if the transformation is not affine, not finite or flattens space */
    public Group {
        toParent = new Matrix4f(toParent);
        children = List.copyOf(children);
        boolean affine = toParent.m03() == 0 && toParent.m13() == 0 && toParent.m23() == 0 && toParent.m33() == 1;
        if (!affine || !toParent.isFinite() || toParent.determinant3x3() == 0) {
            throw new IllegalArgumentException(
                    "a group's transformation must be affine, finite and invertible, not " + toParent);
        }
    }

    public Group(Matrix4fc toParent, Node... children) {
        this(toParent, List.of(children));
    }

    public Group(Node... children) {
        this(new Matrix4f(), children);
    }
}
