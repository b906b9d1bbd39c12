package sunbeam.app.scene;

import sunbeam.precompute.method.TableMethod;

/** How many samples pictures have in a pixel, where nobody says. */
public final class PixelSamples {
    /** Most samples along a pixel's side. */
    public static final int MOST = 8;

    // A pixel of a whole snake is as wide as the body bends, and one sample in each leaves more than eyes allow
    // (docs/color-tables.md).
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
        return (int) Math.max(2, Math.min(MOST, Math.round(Math.sqrt(IN_ALL / ((double) width * height)))));
    }
}
