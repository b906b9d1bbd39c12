package jrtr.scene;

import org.joml.Matrix4f;

/**
 * The part of space that a camera sees, by perspective.
 *
 * @param verticalFieldOfView angle between the bottom and the top of the picture in radians, above 0 and below pi
 * @param near distance of the near plane, above 0
 * @param far distance of the far plane, above near
 */
public record Frustum(float verticalFieldOfView, float near, float far) {

    /** Rejects what is no frustum. */
    public Frustum {
        boolean angle = verticalFieldOfView > 0 && verticalFieldOfView < Math.PI;
        if (!angle || !(near > 0) || !(far > near) || Float.isInfinite(far)) {
            throw new IllegalArgumentException("frustum of " + verticalFieldOfView + " rad from " + near + " to " + far
                    + ": the angle must lie between 0 and pi, and 0 < near < far");
        }
    }

    /**
     * Camera space to clip space for all of a picture or a part of it; depth -1 at the near plane, 1 at the far one.
     * Pixels are square.
     */
    public Matrix4f cameraToClip(PictureArea area) {
        Matrix4f whole = new Matrix4f()
                .perspective(verticalFieldOfView, (float) area.pictureWidth() / area.pictureHeight(), near, far);
        return area.isWhole() ? whole : area.wholeToPart().mul(whole);
    }
}
