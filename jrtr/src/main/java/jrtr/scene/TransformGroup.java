package jrtr.scene;

import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/** A group whose children stand in a coordinate system of their own. */
public final class TransformGroup extends Group {
    private final Matrix4f transformation = new Matrix4f();

    /** A group at its parent's place. */
    public TransformGroup() {}

    /** A group at another place. */
    public TransformGroup(Matrix4fc transformation) {
        setTransformation(transformation);
    }

    /** From the children's coordinates to the parent's: {@code M * v}. */
    public Matrix4fc transformation() {
        return new Matrix4f(transformation);
    }

    /**
     * Moves the children.
     *
     * @param value copied
     * @throws IllegalArgumentException if it is not affine, not finite or flattens space
     */
    public void setTransformation(Matrix4fc value) {
        Matrix4f copy = new Matrix4f(value);
        boolean affine = copy.m03() == 0 && copy.m13() == 0 && copy.m23() == 0 && copy.m33() == 1;
        float determinant = copy.determinant3x3();
        if (!affine || !copy.isFinite() || determinant == 0) {
            throw new IllegalArgumentException(
                    "a group's transformation must be affine, finite and invertible, not " + copy);
        }
        transformation.set(copy);
    }
}
