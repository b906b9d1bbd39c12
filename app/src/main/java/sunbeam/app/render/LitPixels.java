package sunbeam.app.render;

import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.text.Text;

/**
 * Numbers of pixels that a mesh fills by half or more, and of the lit ones among them: those with an sRGB channel of {@link #LEAST_CODE} or
 * more.
 *
 * @param lit lit pixels, 0 to {@code filled}
 * @param filled pixels of the mesh
 */
public record LitPixels(long lit, long filled) {
    public static final LitPixels NONE = new LitPixels(0, 0);

    /** Least sRGB channel, of 255, that is visible beside bright pixels. */
    private static final int LEAST_CODE = 8;

    /**
     * Share of lit pixels below which a picture is black with specks: a grating of 2 um on a bare sphere lights 0.7 % at 320 x 240 pixels
     * and 3 % at 64 x 48, a snake's nanostructure 77 %.
     */
    private static final double LEAST_SHARE = 0.05;

    private static final double LEAST_LIGHT = Srgb.linear(LEAST_CODE);

    /**
     * Counts the pixels of a picture.
     *
     * @param pixels linear light of whole pixels, not of their samples
     */
    public static LitPixels of(ScenePicture pixels, DisplayTransform display) {
        double[] light = new double[3];
        long lit = 0;
        long filled = 0;
        for (int from = 0; from < pixels.rgba().length; from += 4) {
            if (pixels.rgba()[from + 3] >= 0.5f) {
                filled++;
                display.light(pixels.rgba(), from, light);
                lit += Math.max(light[0], Math.max(light[1], light[2])) >= LEAST_LIGHT ? 1 : 0;
            }
        }
        return new LitPixels(lit, filled);
    }

    public LitPixels plus(LitPixels other) {
        return new LitPixels(lit + other.lit, filled + other.filled);
    }

    /** Returns the share of the mesh's pixels that are lit, 0 to 1; 0 if the picture shows no mesh. */
    public double share() {
        return filled == 0 ? 0 : (double) lit / filled;
    }

    /** True if so few pixels are lit that the picture is probably a mistake. */
    public boolean areTooFew() {
        return share() < LEAST_SHARE;
    }

    public String summary() {
        double percent = 100 * share();
        String text = percent < 10 ? Text.format("%.2g", percent) : Text.format("%.0f", percent);
        return "lit: " + text + " % of " + filled + " pixels that the mesh fills";
    }

    /** Returns one line about too few lit pixels, with a remedy. */
    public String complaint() {
        return filled == 0
                ? "the picture shows no mesh; move the camera"
                : Text.format(
                        "only %.2g %% of the mesh is lit: the light goes elsewhere, or is too weak; move the light, or raise"
                                + " roughness, the weights or the exposure",
                        100 * share());
    }
}
