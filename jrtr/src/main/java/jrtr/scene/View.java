package jrtr.scene;

import jrtr.Tile;
import jrtr.gl.ShaderProgram;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/**
 * Perspective view from a camera.
 *
 * @param verticalFieldOfView angle of pictures of {@code leastAspect} or wider, in radians, above 0 and below pi
 * @param leastAspect width over height, at least 0; a narrower picture has the horizontal angle of a picture of this aspect
 * @param near distance of the near plane, above 0; the far plane is farther
 */
public record View(Camera camera, float verticalFieldOfView, float leastAspect, float near, float far) {
    /** Returns the matrix from camera space to clip space, with square pixels and depth -1 at the near plane, 1 at the far one. */
    Matrix4f cameraToClip(Area area) {
        float aspect = (float) area.pictureWidth() / area.pictureHeight();
        Matrix4f whole = new Matrix4f().perspective(verticalFieldOfView, Math.max(aspect, leastAspect), near, far);
        if (aspect < leastAspect) {
            whole.m11(whole.m11() * aspect / leastAspect);
        }
        return area.wholeToPart().mul(whole);
    }

    public Matrix4f worldToClip(Area area) {
        return cameraToClip(area).mul(camera.worldToCamera());
    }

    /**
     * Sets the uniforms of jrtr/view_rays.glsl: the direction towards the viewer in world space, not normalized, as a linear function of
     * the position in pixels from the lower left corner of the part.
     */
    public void applyRaysTo(ShaderProgram program, Area area) {
        Matrix4f toClip = cameraToClip(area);
        Matrix4f toCamera = camera.worldToCamera();
        // The point (x, y, -1) in camera space has clip x = m00 x - m20 and w = 1. Its direction towards the viewer is
        // (-x, -y, 1).
        Vector3f right = toCamera.getRow(0, new Vector3f());
        Vector3f up = toCamera.getRow(1, new Vector3f());
        Vector3f corner = toCamera.getRow(2, new Vector3f())
                .add(right.mul((1 - toClip.m20()) / toClip.m00(), new Vector3f()))
                .add(up.mul((1 - toClip.m21()) / toClip.m11(), new Vector3f()));
        program.set("viewAtCorner", corner);
        program.set("viewPerColumn", right.mul(-2 / (toClip.m00() * area.part().width())));
        program.set("viewPerRow", up.mul(-2 / (toClip.m11() * area.part().height())));
    }

    /** Part of a picture that a target of its size shows. Pictures beyond the driver's largest target are drawn in parts. */
    public record Area(int pictureWidth, int pictureHeight, Tile part) {
        public static Area whole(int width, int height) {
            return new Area(width, height, Tile.whole(width, height));
        }

        Matrix4f wholeToPart() {
            double bottom = (double) pictureHeight - part.y() - part.height();
            double scaleX = (double) pictureWidth / part.width();
            double scaleY = (double) pictureHeight / part.height();
            double moveX = (pictureWidth - 2.0 * part.x() - part.width()) / part.width();
            double moveY = (pictureHeight - 2 * bottom - part.height()) / part.height();
            return new Matrix4f().translation((float) moveX, (float) moveY, 0).scale((float) scaleX, (float) scaleY, 1);
        }
    }

    /**
     * Leaf of a scene graph: position and orientation of a camera, in meters. The vectors must not be changed.
     *
     * @param centerOfProjection the eye
     * @param lookAtPoint point shown at the picture's center
     * @param up points upwards in the picture; any length above 0, not along the line of sight
     */
    public record Camera(Vector3fc centerOfProjection, Vector3fc lookAtPoint, Vector3fc up) implements Node {

        public Camera {
            Vector3f sight = lookAtPoint.sub(centerOfProjection, new Vector3f());
            float across = sight.cross(up, new Vector3f()).length();
            // In float32, at an angle of 1e-5, only two digits of the picture's x axis are correct.
            if (!(across > 1e-5f * sight.length() * up.length()) || Float.isInfinite(across)) {
                throw new IllegalArgumentException("camera at " + numbers(centerOfProjection) + " looking at "
                        + numbers(lookAtPoint) + " with up " + numbers(up)
                        + " has no picture: eye and point must differ and up must not lie along the line of sight");
            }
        }

        /** Returns the camera as seen from another space, to which an affine matrix leads. */
        Camera transformed(Matrix4fc matrix) {
            return (matrix.properties() & Matrix4fc.PROPERTY_IDENTITY) != 0
                    ? this
                    : new Camera(
                            matrix.transformPosition(centerOfProjection, new Vector3f()),
                            matrix.transformPosition(lookAtPoint, new Vector3f()),
                            matrix.transformDirection(up, new Vector3f()));
        }

        private static String numbers(Vector3fc vector) {
            return "(" + vector.x() + ", " + vector.y() + ", " + vector.z() + ")";
        }

        /** The matrix to camera space, where the eye is at the origin and looks along -z, with y upwards and x to the right. */
        public Matrix4f worldToCamera() {
            return new Matrix4f().lookAt(centerOfProjection, lookAtPoint, up);
        }
    }
}
