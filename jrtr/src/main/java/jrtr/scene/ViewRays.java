package jrtr.scene;

import jrtr.gl.ShaderProgram;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Direction towards the viewer as a linear function of the pixel's position: the uniforms of jrtr/view_rays.glsl. The direction is in world
 * space and not normalized; positions are in pixels from the target's lower left corner.
 *
 * @param corner direction at position (0, 0)
 * @param perColumn change per pixel to the right
 * @param perRow change per pixel upwards
 */
public record ViewRays(Vector3fc corner, Vector3fc perColumn, Vector3fc perRow) {

    /** Computes the function for a part of a picture. */
    public static ViewRays of(Camera camera, Frustum frustum, PictureArea area) {
        Matrix4f toClip = frustum.cameraToClip(area);
        Matrix4f toCamera = camera.worldToCamera();
        // The point (x, y, -1) in camera space has clip x = m00 x - m20 and w = 1. Its direction towards the viewer is
        // (-x, -y, 1).
        Vector3f perColumn =
                row(toCamera, 0).mul(-2 / (toClip.m00() * area.part().width()));
        Vector3f perRow = row(toCamera, 1).mul(-2 / (toClip.m11() * area.part().height()));
        Vector3f corner = row(toCamera, 2)
                .add(row(toCamera, 0).mul((1 - toClip.m20()) / toClip.m00()))
                .add(row(toCamera, 1).mul((1 - toClip.m21()) / toClip.m11()));
        return new ViewRays(corner, perColumn, perRow);
    }

    private static Vector3f row(Matrix4f worldToCamera, int row) {
        return new Vector3f(worldToCamera.get(0, row), worldToCamera.get(1, row), worldToCamera.get(2, row));
    }

    public void applyTo(ShaderProgram program) {
        program.set("viewAtCorner", corner);
        program.set("viewPerColumn", perColumn);
        program.set("viewPerRow", perRow);
    }
}
