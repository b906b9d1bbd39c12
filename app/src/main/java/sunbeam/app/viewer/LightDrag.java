package sunbeam.app.viewer;

import jrtr.scene.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/** Moving the light by dragging: it goes where the mouse goes, on a sphere around the model. */
public final class LightDrag {
    private LightDrag() {}

    /**
     * The light's direction after a drag.
     *
     * @param towards unit vector to the light, world space
     * @param right angle to the picture's right, radians
     * @param up angle upwards in the picture, radians
     * @return unit length
     */
    public static Vector3f moved(Camera camera, Vector3fc towards, double right, double up) {
        Matrix4f worldToCamera = camera.worldToCamera();
        Vector3f seen = worldToCamera.transformDirection(towards, new Vector3f());
        seen.rotateY((float) right).rotateX((float) -up);
        return worldToCamera.invertAffine().transformDirection(seen).normalize();
    }
}
