package sunbeam.app.scene;

import jrtr.scene.View.Camera;

/** Camera (meters, world space) and field of view, radians, of pictures of 4:3 or wider; narrower ones have the width of 4:3. */
public record Viewpoint(Camera camera, double verticalFieldOfView) {
    /** Width over height below which a picture shows more above and below. */
    public static final double LEAST_ASPECT = 4.0 / 3;

    /** Radians; single precision does not resolve less. */
    public static final double NARROWEST = Math.toRadians(0.001);

    /** Radians; wider pictures are mostly distortion. */
    public static final double WIDEST = Math.toRadians(170);

    public double halfHeight(int width, int height) {
        return Math.tan(verticalFieldOfView / 2) * Math.max(1, LEAST_ASPECT * height / width);
    }
}
