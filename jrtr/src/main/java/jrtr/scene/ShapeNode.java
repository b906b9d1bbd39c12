package jrtr.scene;

import java.util.Objects;

/**
 * A leaf that is drawn.
 *
 * @param shape what
 */
public record ShapeNode(Shape shape) implements Node {

    /** Rejects null. */
    public ShapeNode {
        Objects.requireNonNull(shape, "shape");
    }
}
