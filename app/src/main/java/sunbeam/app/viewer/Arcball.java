package sunbeam.app.viewer;

import jrtr.scene.Camera;
import org.joml.Quaternionf;
import org.joml.Quaternionfc;
import org.joml.Vector3f;

/**
 * Turning a model by dragging (K. Shoemake, "ARCBALL", Graphics Interface 1992): the picture is the view of a ball; the
 * point that was grabbed follows the mouse. Points are (x, y) in the ball's radii from its middle, y upwards.
 */
public final class Arcball {
    private Arcball() {}

    /**
     * The turn in world space that takes the ball's one point to the other.
     *
     * @return unit length
     */
    public static Quaternionf turn(Camera camera, double fromX, double fromY, double toX, double toY) {
        Vector3f from = onBall(fromX, fromY);
        Vector3f to = onBall(toX, toY);
        // Shoemake's product: twice the arc, so that a drag across the ball turns it once around.
        Vector3f axis = from.cross(to, new Vector3f());
        Quaternionf inCamera = new Quaternionf(axis.x, axis.y, axis.z, from.dot(to)).normalize();
        Quaternionf worldToCamera = camera.worldToCamera().getUnnormalizedRotation(new Quaternionf());
        return worldToCamera.conjugate(new Quaternionf()).mul(inCamera).mul(worldToCamera);
    }

    /** A turn after an orientation, kept at unit length over many drags. */
    public static Quaternionf turned(Quaternionfc orientation, Quaternionfc turn) {
        return turn.mul(orientation, new Quaternionf()).normalize();
    }

    /** The ball's point under the mouse, camera space; beside the ball, the nearest one of its rim. */
    static Vector3f onBall(double x, double y) {
        double squared = x * x + y * y;
        if (squared >= 1) {
            double radius = Math.sqrt(squared);
            return new Vector3f((float) (x / radius), (float) (y / radius), 0);
        }
        return new Vector3f((float) x, (float) y, (float) Math.sqrt(1 - squared));
    }
}
