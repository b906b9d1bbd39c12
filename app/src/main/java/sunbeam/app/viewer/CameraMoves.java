package sunbeam.app.viewer;

import jrtr.scene.Camera;
import org.joml.Vector3f;
import sunbeam.app.scene.Viewpoint;

/** Zooming and panning. */
public final class CameraMoves {
    // The near and far planes follow the mesh, but numbers in float32 must stay apart.
    private static final float NEAREST = 1e-6f;
    private static final float FARTHEST = 1e6f;

    private CameraMoves() {}

    /**
     * Brings the eye nearer to the point it looks at.
     *
     * @param factor of the distance; below 1 zooms in
     */
    public static Viewpoint zoomed(Viewpoint view, double factor) {
        Camera camera = view.camera();
        Vector3f back = camera.centerOfProjection().sub(camera.lookAtPoint(), new Vector3f());
        float distance = (float) Math.min(FARTHEST, Math.max(NEAREST, back.length() * factor));
        Vector3f eye = back.normalize(distance).add(camera.lookAtPoint());
        return new Viewpoint(new Camera(eye, camera.lookAtPoint(), camera.up()), view.verticalFieldOfView());
    }

    /**
     * Shifts eye and point sideways, so that what is seen follows the mouse.
     *
     * @param right drag to the right, in picture heights
     * @param up drag upwards, in picture heights
     * @param width of the picture, in any unit
     * @param height of the picture, in the same
     */
    public static Viewpoint panned(Viewpoint view, double right, double up, int width, int height) {
        Camera camera = view.camera();
        Vector3f sight = camera.lookAtPoint().sub(camera.centerOfProjection(), new Vector3f());
        double seen = 2 * sight.length() * view.halfHeight(width, height);
        Vector3f toRight = sight.cross(camera.up(), new Vector3f()).normalize();
        Vector3f toTop = toRight.cross(sight, new Vector3f()).normalize();
        Vector3f shift = toRight.mul((float) (-right * seen)).add(toTop.mul((float) (-up * seen)));
        return new Viewpoint(
                new Camera(
                        camera.centerOfProjection().add(shift, new Vector3f()),
                        camera.lookAtPoint().add(shift, new Vector3f()),
                        camera.up()),
                view.verticalFieldOfView());
    }
}
