package sunbeam.app.viewer.model;

import jrtr.VertexData.BoundingSphere;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Motion;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Viewpoint;

/** Geometry of mouse drags and wheel turns that move model, light or camera. */
public final class Drags {
    // Distances from eye to target, in meters. Beyond, float32 coordinates of both would coincide or lose the mesh.
    private static final float NEAREST = 1e-6f;
    private static final float FARTHEST = 1e6f;

    // Depth of a light that is seen on the rim between both sides of the model; rounding errors are smaller.
    private static final float RIM = 1e-3f;

    private Drags() {}

    /**
     * Turns the model about its own vertical and tilts it about the picture's horizontal, so that an upright model stays upright. Its front
     * turns to the picture's right and upwards by these angles, in radians.
     */
    public static Scene turned(Scene scene, double right, double up) {
        Camera camera = scene.view().camera();
        Vector3f sight = sight(camera);
        Vector3f toRight = sight.cross(camera.up(), new Vector3f()).normalize();
        Vector3f vertical =
                scene.orientation().transform(camera.up(), new Vector3f()).normalize();
        // The front of a model that hangs upside down turns the other way around its vertical.
        double turn = vertical.dot(toRight.cross(sight, new Vector3f())) < 0 ? -right : right;
        return Motion.turned(scene, rotation(-up, toRight).mul(rotation(turn, vertical)));
    }

    /** Rolls the model about the line of sight, counterclockwise in the picture; the angle is in radians. */
    public static Scene rolled(Scene scene, double angle) {
        return Motion.turned(
                scene, rotation(-angle, sight(scene.view().camera()).normalize()));
    }

    private static Quaternionf rotation(double angle, Vector3fc axis) {
        return new Quaternionf().rotationAxis((float) angle, axis);
    }

    private static Vector3f sight(Camera camera) {
        return camera.lookAtPoint().sub(camera.centerOfProjection(), new Vector3f());
    }

    /**
     * Moves the light on a sphere around the model, to the picture's right and upwards by these angles, in radians; an environment turns
     * about the vertical.
     */
    public static Scene lit(Scene scene, double right, double up) {
        if (scene.hasEnvironment()) {
            return Motion.lightTurned(scene, right);
        }
        Matrix4f worldToCamera = scene.view().camera().worldToCamera();
        Vector3f seen = worldToCamera.transformDirection(scene.light().towards(), new Vector3f());
        seen.rotateY((float) right).rotateX((float) -up);
        Vector3f towards = worldToCamera.invertAffine().transformDirection(seen).normalize();
        return scene.withLight(scene.light().pointing(towards));
    }

    /**
     * Points the light so that its direction is seen at a place of the picture, on its present side of the model.
     *
     * @param right in camera space: components of the unit vector to the light, as {@code up}; a vector longer than 1 is shortened
     */
    public static Scene litAt(Scene scene, double right, double up) {
        Matrix4f worldToCamera = scene.view().camera().worldToCamera();
        boolean isBehind = worldToCamera.transformDirection(scene.light().towards(), new Vector3f()).z < -RIM;
        double longest = Math.max(1, Math.hypot(right, up));
        double x = right / longest;
        double y = up / longest;
        double z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
        Vector3f seen = new Vector3f((float) x, (float) y, (float) (isBehind ? -z : z));
        Vector3f towards = worldToCamera.invertAffine().transformDirection(seen).normalize();
        return scene.withLight(scene.light().pointing(towards));
    }

    /**
     * Moves the eye towards the point under the pointer, which stays at its pixel.
     *
     * @param factor factor on the distance; below 1 zooms in
     * @param right pointer's offset from the picture's center, in picture heights, like {@code up}
     * @param width of the picture, in any unit that the height has, too
     */
    public static Scene zoomed(Scene scene, double factor, double right, double up, int width, int height) {
        Camera camera = scene.view().camera();
        float distance = camera.lookAtPoint().distance(camera.centerOfProjection());
        float allowed = (float) Math.min(FARTHEST, Math.max(NEAREST, distance * factor)) / distance;
        // Scaling about the point under the pointer leaves that point on the pointer's ray.
        return shifted(scene, across(scene.view(), right, up, width, height).mul(1 - allowed), allowed);
    }

    /** Shifts eye and target sideways by a drag in picture heights, so that the picture follows the mouse. */
    public static Scene panned(Scene scene, double right, double up, int width, int height) {
        return shifted(scene, across(scene.view(), -right, -up, width, height), 1);
    }

    public static Scene framed(Scene scene, BoundingSphere sphere) {
        Viewpoint view = scene.view();
        Camera camera = view.camera();
        float distance = (float) Math.min(
                FARTHEST, Math.max(NEAREST, sphere.radius() / Math.sin(view.verticalFieldOfView() / 2)));
        Vector3f back = camera.centerOfProjection().sub(camera.lookAtPoint(), new Vector3f());
        Vector3f eye = back.normalize(distance).add(sphere.center());
        return scene.withView(new Viewpoint(new Camera(eye, sphere.center(), camera.up()), view.verticalFieldOfView()));
    }

    /** Shifts eye and target, and multiplies their distance by a factor. */
    public static Scene shifted(Scene scene, Vector3fc shift, float factor) {
        Camera camera = scene.view().camera();
        Vector3f back = camera.centerOfProjection().sub(camera.lookAtPoint(), new Vector3f());
        Vector3f lookAt = camera.lookAtPoint().add(shift, new Vector3f());
        Vector3f eye = back.mul(factor).add(lookAt);
        return scene.withView(
                new Viewpoint(new Camera(eye, lookAt, camera.up()), scene.view().verticalFieldOfView()));
    }

    /** Returns the world-space vector, in the plane through the target, of an offset given in picture heights. */
    private static Vector3f across(Viewpoint view, double right, double up, int width, int height) {
        Camera camera = view.camera();
        Vector3f sight = sight(camera);
        double seen = 2 * sight.length() * view.halfHeight(width, height);
        Vector3f toRight = sight.cross(camera.up(), new Vector3f()).normalize();
        Vector3f toTop = toRight.cross(sight, new Vector3f()).normalize();
        return toRight.mul((float) (right * seen)).add(toTop.mul((float) (up * seen)));
    }
}
