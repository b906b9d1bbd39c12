package sunbeam.app.scene;

import jrtr.scene.View.Camera;

/**
 * Camera and field of view of a scene.
 *
 * @param camera meters, world space
 * @param verticalFieldOfView angle between the bottom and top of a picture of 4:3 or wider, radians, {@link #NARROWEST} to {@link #WIDEST};
 *     a narrower picture shows as much from left to right as one of 4:3
 */
public record Viewpoint(Camera camera, double verticalFieldOfView) {
    /** Width over height below which a picture keeps its horizontal field of view and shows more above and below. */
    public static final double LEAST_ASPECT = 4.0 / 3;

    /** Narrowest field of view, radians; single precision does not resolve narrower ones. */
    public static final double NARROWEST = Math.toRadians(0.001);

    /** Widest field of view, radians; wider pictures are mostly distortion. */
    public static final double WIDEST = Math.toRadians(170);

    public double halfHeight(int width, int height) {
        return Math.tan(verticalFieldOfView / 2) * Math.max(1, LEAST_ASPECT * height / width);
    }
}
