package sunbeam.app.scene;

import java.util.OptionalDouble;
import jrtr.VertexData.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Place of a mesh in the model.
 *
 * @param position moves the mesh, meters
 * @param orientation rotation about the middle of the mesh's bounding sphere; unit length
 * @param size length of the longest side of the box around the unturned mesh, meters, above 0; empty for its own
 */
public record Placement(Vector3fc position, Quaternionfc orientation, OptionalDouble size) {
    public static final Placement NONE = new Placement(new Vector3f(), new Quaternionf(), OptionalDouble.empty());

    public Placement {
        position = new Vector3f(position);
        orientation = new Quaternionf(orientation);
    }

    /**
     * Returns the matrix from a mesh's space to the model's.
     *
     * @param bounds sphere around the mesh
     * @param longestSide longest side of the box around the mesh, meters, above 0
     */
    public Matrix4f toModel(BoundingSphere bounds, double longestSide) {
        if (equals(NONE)) {
            return new Matrix4f();
        }
        Vector3fc center = bounds.center();
        float scale = (float) (size.orElse(longestSide) / longestSide);
        return new Matrix4f()
                .translation(center.add(position, new Vector3f()))
                .rotate(orientation)
                .scale(scale)
                .translate(center.negate(new Vector3f()));
    }
}
