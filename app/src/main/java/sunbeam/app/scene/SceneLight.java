package sunbeam.app.scene;

import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * The light: parallel rays.
 *
 * @param towards from the scene to the light, world space; given in any length above 0, kept in length 1
 * @param intensity factor for all that the light makes visible, at least 0
 */
public record SceneLight(Vector3fc towards, double intensity) {

    /** Normalises the direction; rejects one without length. */
    public SceneLight {
        float length = towards.length();
        if (!(length > 0) || Float.isInfinite(length)) {
            throw new IllegalArgumentException("the light's direction (" + towards.x() + ", " + towards.y() + ", "
                    + towards.z() + ") has no direction");
        }
        // A direction that was kept before stays the same to the last bit.
        towards = Math.abs(length - 1) < 1e-6f ? new Vector3f(towards) : towards.div(length, new Vector3f());
    }
}
