package sunbeam.app.scene;

import static sunbeam.app.scene.SceneSettings.FIELD_OF_VIEW;

import java.util.Objects;
import jrtr.scene.Camera;

/**
 * From where a scene is seen, and how much of it.
 *
 * @param camera metres, world space
 * @param verticalFieldOfView angle between the picture's bottom and top, radians, {@link #NARROWEST} to {@link #WIDEST}
 */
public record Viewpoint(Camera camera, double verticalFieldOfView) {
    /** In narrower pictures single precision ends. */
    public static final double NARROWEST = Math.toRadians(0.001);

    /** Wider pictures show nothing but distortion. */
    public static final double WIDEST = Math.toRadians(170);

    /** Rejects angles that are none. */
    public Viewpoint {
        Objects.requireNonNull(camera, "camera");
        FIELD_OF_VIEW.kind().check(verticalFieldOfView);
    }
}
