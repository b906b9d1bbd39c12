package sunbeam.app.scene;

import sunbeam.precompute.method.TableMethod;

/** How many samples pictures have in a pixel, where nobody says. */
public final class PixelSamples {
    /** Most samples along a pixel's side. */
    public static final int MOST = 8;

    // Of 2 x 2 in 1200 x 800 pixels: fewer in all miss the rims of a snake's scales by more than eyes allow (a mean
    // CIEDE2000 of
    // 1), in a picture of any size.
    private static final double IN_ALL = 2400.0 * 1600;

    private PixelSamples() {}

    /**
     * Samples along the side of a pixel: 2 by method table, more in pictures of few pixels, of which each sees more of a mesh; 1
     * by methods whose samples are costly.
     *
     * @param width pixels per row
     * @param height rows
     * @return 1 to {@link #MOST}
     */
    public static int alongSide(SceneMethod method, int width, int height) {
        if (!method.type().equals(TableMethod.TYPE)) {
            return 1;
        }
        return (int) Math.max(2, Math.min(MOST, Math.ceil(Math.sqrt(IN_ALL / ((double) width * height)))));
    }
}
