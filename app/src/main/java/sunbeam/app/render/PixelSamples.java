package sunbeam.app.render;

import java.util.List;
import java.util.stream.Collectors;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.text.Text;

/**
 * Square of {@code side x side} samples. With adaptive samples a pixel has its <em>first</em> samples, one in each row and column of the
 * square with a larger footprint. While the mean is unsure, as at rims, squares of more samples follow.
 *
 * @param side from 1 to {@link #MOST}; even if adaptive
 * @param refinements sides of the squares that follow the first samples, the first {@code side}; empty for uniform samples
 */
public record PixelSamples(int side, List<Integer> refinements) {
    public static final int MOST = 8;

    // Samples of 2 x 2 per pixel at 1280 x 720. With fewer, the rims of a snake's scales differ visibly from their
    // exact color (mean CIEDE2000 above 1), whatever the picture's size.
    private static final double PICTURE_SAMPLES = 2560.0 * 1440;

    private static final int LEAST_ADAPTIVE = 4;

    public static PixelSamples uniform(int side) {
        return new PixelSamples(side, List.of());
    }

    /** Method {@code table} has adaptive samples, more in a small picture; methods whose samples are costly have one. */
    public static PixelSamples of(SceneMethod method, int width, int height) {
        if (!method.isTable()) {
            return uniform(1);
        }
        int side = side(width, height);
        int even = side + side % 2;
        // Glints at rims of scales are narrower than a sample of a small picture.
        return side < LEAST_ADAPTIVE
                ? new PixelSamples(LEAST_ADAPTIVE, List.of(LEAST_ADAPTIVE))
                : new PixelSamples(even, List.of(even, 2 * even));
    }

    /** In a window samples are uniform: their tiles are known before the picture is drawn. */
    public static PixelSamples inWindow(SceneMethod method, int width, int height) {
        return uniform(method.isTable() ? side(width, height) : 1);
    }

    private static int side(int width, int height) {
        return (int) Math.max(2, Math.min(MOST, Math.ceil(Math.sqrt(PICTURE_SAMPLES / ((double) width * height)))));
    }

    /** Such as "16 samples a pixel (--supersample 4)". */
    public String describe() {
        String finer = refinements.stream().map(next -> "" + next * next).collect(Collectors.joining(" or "));
        return isAdaptive()
                ? Text.format("%d or, where these differ, %s samples a pixel", side, finer)
                : side == 1
                        ? "1 sample a pixel"
                        : Text.format("%d samples a pixel (--supersample %d)", side * side, side);
    }

    public boolean isAdaptive() {
        return !refinements.isEmpty();
    }

    int firstAcross() {
        return isAdaptive() ? 1 : side;
    }

    /** Column of the first sample in a row of a pixel's square; no two rows have the same. */
    static int firstColumn(int row, int side) {
        return 2 * (row + 1) % (side + 1) - 1;
    }
}
