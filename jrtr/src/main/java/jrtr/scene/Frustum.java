package jrtr.scene;

import org.joml.Matrix4f;

/**
 * The part of space that a camera sees, by perspective.
 *
 * @param verticalFieldOfView angle between the bottom and the top of the picture in radians, above 0 and below pi, where
 *     the picture is as wide as {@code leastAspect} wants it
 * @param leastAspect width over height, above 0 or 0 itself: a narrower picture shows as much from left to right as one
 *     with this aspect, and more above and below
 * @param near distance of the near plane, above 0
 * @param far distance of the far plane, above near
 */
public record Frustum(float verticalFieldOfView, float leastAspect, float near, float far) {

    /** Rejects what is no frustum. */
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

    /** The angle holds for pictures of any width. */
    public Frustum(float verticalFieldOfView, float near, float far) {
        this(verticalFieldOfView, 0, near, far);
    }

    /**
     * Camera space to clip space for all of a picture or a part of it; depth -1 at the near plane, 1 at the far one.
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
