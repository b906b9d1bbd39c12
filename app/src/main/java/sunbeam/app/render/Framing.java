package sunbeam.app.render;

import java.util.List;
import jrtr.VertexData.BoundingSphere;
import jrtr.scene.Light;
import jrtr.scene.View;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scene.Viewpoint;

/** Lights, views and placed meshes of scenes. */
final class Framing {
    // Distance of both planes from the mesh's center, in its radii; above 1, so that rounding clips nothing.
    private static final float MARGIN = 1.02f;
    // Near plane to far plane, for an eye inside the mesh's sphere; suits a 32-bit depth buffer.
    private static final float NEAREST = 1e-3f;
    // Distance of both planes from the mesh's center relative to the eye's, so that float32 separates them.
    private static final float THINNEST = 1e-4f;

    private Framing() {}

    /** Returns lights in world space, the key light first. */
    static List<Light> lights(Scene scene) {
        return scene.lights().stream()
                .map(light -> new Light(light.towards(), new Vector3f((float) light.intensity())))
                .toList();
    }

    /** Variance of each light's directions, in the order of {@link #lights}, in square radians. */
    static float[] variances(Scene scene) {
        float[] variances = new float[scene.lights().size()];
        for (int i = 0; i < variances.length; i++) {
            variances[i] = (float) Math.pow(scene.deviation(scene.lights().get(i)), 2);
        }
        return variances;
    }

    static Matrix4f toWorld(Quaternionfc orientation, BoundingSphere bounds) {
        Vector3fc center = bounds.center();
        return new Matrix4f().translation(center).rotate(orientation).translate(-center.x(), -center.y(), -center.z());
    }

    /** True if the near plane, and so the eye, is in front of the mesh in any orientation. */
    static boolean seesFromOutside(View view) {
        return view.near() > NEAREST * view.far();
    }

    static View view(Viewpoint view, BoundingSphere bounds) {
        Camera camera = view.camera();
        Vector3f sight = camera.lookAtPoint().sub(camera.centerOfProjection(), new Vector3f());
        // From the eye to the mesh's center, along the line of sight.
        float distance =
                bounds.center().sub(camera.centerOfProjection(), new Vector3f()).dot(sight.normalize());
        float reach = Math.max(MARGIN * bounds.radius(), THINNEST * Math.abs(distance));
        // A mesh behind the eye is invisible with any planes.
        float far = Math.max(distance, 0) + reach;
        return new View(
                camera,
                (float) view.verticalFieldOfView(),
                (float) Viewpoint.LEAST_ASPECT,
                Math.max(distance - reach, NEAREST * far),
                far);
    }
}
