package jrtr.scene;

import org.joml.Matrix4f;

/**
 * Perspective view frustum.
 *
 * @param verticalFieldOfView angle between the bottom and the top of the picture in radians, above 0 and below pi; holds for
 *     pictures of {@code leastAspect} or wider
 * @param leastAspect width over height, at least 0: a narrower picture keeps the horizontal angle of a picture with this
 *     aspect and shows more above and below
 * @param near distance of the near plane, above 0
 * @param far distance of the far plane, above near
 */
public record Frustum(float verticalFieldOfView, float leastAspect, float near, float far) {

    public Frustum {
        boolean angle = verticalFieldOfView > 0 && verticalFieldOfView < Math.PI;
        if (!(leastAspect >= 0) || Float.isInfinite(leastAspect)) {
            throw new IllegalArgumentException("least aspect " + leastAspect + " of a frustum; it must be 0 or above");
        }
        if (!angle || !(near > 0) || !(far > near) || Float.isInfinite(far)) {
            throw new IllegalArgumentException("frustum of " + verticalFieldOfView + " rad from " + near + " to " + far
                    + ": the angle must lie between 0 and pi, and 0 < near < far");
        }
    }

    /** Frustum with the same vertical angle for every aspect. */
    public Frustum(float verticalFieldOfView, float near, float far) {
        this(verticalFieldOfView, 0, near, far);
    }

    /**
     * Returns the matrix from camera space to clip space for a picture or a part of it: depth -1 at the near plane, 1 at the far one.
     * Pixels are square.
     */
    public Matrix4f cameraToClip(PictureArea area) {
        float aspect = (float) area.pictureWidth() / area.pictureHeight();
        Matrix4f whole = new Matrix4f().perspective(verticalFieldOfView, Math.max(aspect, leastAspect), near, far);
        if (aspect < leastAspect) {
            whole.m11(whole.m11() * aspect / leastAspect);
        }
        return area.isWhole() ? whole : area.wholeToPart().mul(whole);
    }
}
