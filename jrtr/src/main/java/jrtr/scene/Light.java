package jrtr.scene;

import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * A directional light: parallel rays, as from the sun. Parent groups transform its direction.
 *
 * @param towards unit vector from the scene to the light; normalized by the constructor
 * @param radiance linear color in the unit of the application's shaders; copied
 */
public record Light(Vector3fc towards, Vector3fc radiance) implements Node {

    public Light {
        float length = towards.length();
        if (!(length > 0) || Float.isInfinite(length)) {
            throw new IllegalArgumentException("light's direction (" + towards.x() + ", " + towards.y() + ", "
                    + towards.z() + ") must have a finite length above 0");
        }
        towards = towards.div(length, new Vector3f());
        radiance = new Vector3f(radiance);
    }

    /** Returns this light with its direction transformed by the matrix's linear part. */
    public Light transformed(Matrix4fc transformation) {
        return new Light(transformation.transformDirection(towards, new Vector3f()), radiance);
    }
}
