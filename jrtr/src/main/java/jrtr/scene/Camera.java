package jrtr.scene;

import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Position and orientation of a camera in world space, in meters; vectors are copied.
 *
 * @param centerOfProjection the eye
 * @param lookAtPoint point shown at the picture's center
 * @param up points upwards in the picture; any length above 0, not along the line of sight
 */
public record Camera(Vector3fc centerOfProjection, Vector3fc lookAtPoint, Vector3fc up) {

    public Camera {
        centerOfProjection = new Vector3f(centerOfProjection);
        lookAtPoint = new Vector3f(lookAtPoint);
        up = new Vector3f(up);
        Vector3f sight = lookAtPoint.sub(centerOfProjection, new Vector3f());
        float across = sight.cross(up, new Vector3f()).length();
        // In float32, at an angle of 1e-5 between the line of sight and up, only two digits of the picture's x axis are
        // correct.
        if (!(across > 1e-5f * sight.length() * up.length()) || Float.isInfinite(across)) {
            throw new IllegalArgumentException("camera at " + numbers(centerOfProjection) + " looking at "
                    + numbers(lookAtPoint) + " with up " + numbers(up)
                    + " has no picture: eye and point must differ and up must not lie along the line of sight");
        }
    }

    private static String numbers(Vector3fc vector) {
        return "(" + vector.x() + ", " + vector.y() + ", " + vector.z() + ")";
    }

    /**
     * Returns the matrix from world to camera space, where the eye is at the origin and looks along -z, with y upwards and x to the right.
     */
    public Matrix4f worldToCamera() {
        return new Matrix4f().lookAt(centerOfProjection, lookAtPoint, up);
    }
}
