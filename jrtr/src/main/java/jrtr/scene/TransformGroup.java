package jrtr.scene;

import org.joml.Matrix4f;
import org.joml.Matrix4fc;

/** A group whose children stand in a coordinate system of their own. */
public final class TransformGroup extends Group {
    private final Matrix4f transformation;

    /**
     * A group at another place.
     *
     * @param transformation from the children's coordinates to the parent's, {@code M * v}; copied
     * @throws IllegalArgumentException if it is not affine, not finite or flattens space
     */
    public TransformGroup(Matrix4fc transformation) {
        Matrix4f copy = new Matrix4f(transformation);
        boolean affine = copy.m03() == 0 && copy.m13() == 0 && copy.m23() == 0 && copy.m33() == 1;
        float determinant = copy.determinant3x3();
        if (!affine || !copy.isFinite() || determinant == 0) {
            throw new IllegalArgumentException(
                    "a group's transformation must be affine, finite and invertible, not " + copy);
        }
        this.transformation = copy;
    }

    /** From the children's coordinates to the parent's: {@code M * v}. */
    public Matrix4fc transformation() {
        return new Matrix4f(transformation);
    }
}
