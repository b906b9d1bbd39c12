package sunbeam.app.scene;

import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * A light with parallel rays.
 *
 * @param towards direction from the scene to the light, world space; normalized from any length above 0
 * @param intensity factor of the light's radiance, at least 0
 */
public record SceneLight(Vector3fc towards, double intensity) {

    public SceneLight {
        float length = towards.length();
        if (!(length > 0) || Float.isInfinite(length)) {
            throw new IllegalArgumentException("the light's direction (" + towards.x() + ", " + towards.y() + ", "
                    + towards.z() + ") has no direction");
        }
        // A direction that is already normalized keeps its bits, so that a scene read back equals the written one.
        towards = Math.abs(length - 1) < 1e-6f ? new Vector3f(towards) : towards.div(length, new Vector3f());
    }
}
