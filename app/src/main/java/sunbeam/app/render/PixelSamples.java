package sunbeam.app.render;

import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.TableMethod;

/** Default numbers of samples per pixel. */
public final class PixelSamples {
    /** Most samples along a pixel's side. */
    public static final int MOST = 8;

    // Fewest samples of a whole picture: 2 x 2 per pixel at 1280 x 720. With fewer, the rims of a snake's scales differ
    // visibly from their exact color (mean CIEDE2000 above 1), whatever the picture's size.
    private static final double PICTURE_SAMPLES = 2560.0 * 1440;

    private PixelSamples() {}

    /**
     * Returns the number of samples along a pixel's side. Method {@code table} has 2, or more in a picture with fewer than 1280 x 720
     * pixels; methods whose samples are costly have 1.
     *
     * @return 1 to {@link #MOST}
     */
    public static int alongSide(SceneMethod method, int width, int height) {
        if (!method.type().equals(TableMethod.TYPE)) {
            return 1;
        }
        return (int) Math.max(2, Math.min(MOST, Math.ceil(Math.sqrt(PICTURE_SAMPLES / ((double) width * height)))));
    }
}
