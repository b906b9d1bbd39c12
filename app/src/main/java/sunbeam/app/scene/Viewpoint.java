package sunbeam.app.scene;

import java.util.Objects;
import jrtr.scene.Camera;

/**
 * From where a scene is seen, and how much of it.
 *
 * @param camera metres, world space
 * @param verticalFieldOfView angle between the picture's bottom and top, radians, above 0 and at most 170 degrees
 */
public record Viewpoint(Camera camera, double verticalFieldOfView) {
    /** Wider pictures show nothing but distortion. */
    public static final double WIDEST = Math.toRadians(170);

    /** Rejects angles that are none. */
    public Viewpoint {
        Objects.requireNonNull(camera, "camera");
        if (!(verticalFieldOfView > 0 && verticalFieldOfView <= WIDEST)) {
            throw new IllegalArgumentException("field of view " + Math.toDegrees(verticalFieldOfView)
                    + " degrees is out of range; give more than 0 and at most 170");
        }
    }
}
