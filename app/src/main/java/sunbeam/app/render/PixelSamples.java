package sunbeam.app.render;

import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.method.TableMethod;

/** Default numbers of samples per pixel. */
public final class PixelSamples {
    /** Most samples along a pixel's side. */
    public static final int MOST = 8;

    // Samples of a whole picture: 2 x 2 a pixel at 1280 x 720. With fewer, a picture of any size misses the rims of a
    // snake's scales by more than eyes allow (mean CIEDE2000 of 1).
    private static final double PICTURE_SAMPLES = 2560.0 * 1440;

    private PixelSamples() {}

    /**
     * Returns the samples along a pixel's side: by method table 2, or more in a picture with fewer than 1280 x 720 pixels; 1 by
     * methods whose samples are costly.
     *
     * @param width pixels per row
     * @param height rows
     * @return 1 to {@link #MOST}
     */
    public static int alongSide(SceneMethod method, int width, int height) {
        if (!method.type().equals(TableMethod.TYPE)) {
            return 1;
        }
        return (int) Math.max(2, Math.min(MOST, Math.ceil(Math.sqrt(PICTURE_SAMPLES / ((double) width * height)))));
    }
}
