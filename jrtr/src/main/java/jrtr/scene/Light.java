package jrtr.scene;

import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * A directional light: parallel rays, as from the sun. The groups above it turn its direction.
 *
 * @param towards unit vector from the scene to the light; given in any length above 0, kept in length 1
 * @param radiance linear color, in the unit that the application's shaders agree on; copied
 */
public record Light(Vector3fc towards, Vector3fc radiance) implements Node {

    /** Normalises the direction; rejects one without length. */
    public Light {
        float length = towards.length();
        if (!(length > 0) || Float.isInfinite(length)) {
            throw new IllegalArgumentException("light's direction (" + towards.x() + ", " + towards.y() + ", "
                    + towards.z() + ") has no direction");
        }
        towards = towards.div(length, new Vector3f());
        radiance = new Vector3f(radiance);
    }

    /** This light with its direction turned by a matrix's linear part. */
    public Light transformed(Matrix4fc transformation) {
        return new Light(transformation.transformDirection(towards, new Vector3f()), radiance);
    }
}
