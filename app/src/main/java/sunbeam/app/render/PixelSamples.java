package sunbeam.app.render;

import java.util.BitSet;
import java.util.stream.IntStream;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.text.Text;

/**
 * Samples of a pixel: a square of {@code side x side}. With adaptive samples a pixel has its <em>first</em> samples, one in each row and
 * column of the square with a larger footprint, and all samples instead only if these differ visibly, as at rims.
 *
 * @param side samples along a pixel's side, 1 to {@link #MOST}; even if adaptive
 */
public record PixelSamples(int side, boolean isAdaptive) {
    /** Most samples along a pixel's side. */
    public static final int MOST = 8;

    // Fewest samples of a whole picture: 2 x 2 per pixel at 1280 x 720. With fewer, the rims of a snake's scales differ
    // visibly from their exact color (mean CIEDE2000 above 1), whatever the picture's size.
    private static final double PICTURE_SAMPLES = 2560.0 * 1440;

    // Least side of adaptive samples.
    private static final int LEAST_ADAPTIVE = 4;

    // Least difference of a channel's display light, as a square root (about sRGB, 0 to 1), between first samples of a
    // pixel that gets all samples: half as much changes pictures by a color difference of 0.02 in the mean.
    private static final double LEAST_DIFFERENCE = 0.12;

    private static final int CHANNELS = 4;

    /** Returns samples that all pixels have. */
    public static PixelSamples uniform(int side) {
        return new PixelSamples(side, false);
    }

    /**
     * Returns the default samples. Method {@code table} has adaptive ones, more in a small picture; methods whose samples are costly have
     * one.
     */
    public static PixelSamples of(SceneMethod method, int width, int height) {
        if (!method.type().equals(TableMethod.TYPE)) {
            return uniform(1);
        }
        int side = side(width, height);
        return new PixelSamples(Math.max(LEAST_ADAPTIVE, side + side % 2), true);
    }

    /** Returns the samples of a picture in a window: uniform ones, whose tiles are known before the picture is drawn. */
    public static PixelSamples inWindow(SceneMethod method, int width, int height) {
        return uniform(method.type().equals(TableMethod.TYPE) ? side(width, height) : 1);
    }

    private static int side(int width, int height) {
        return (int) Math.max(2, Math.min(MOST, Math.ceil(Math.sqrt(PICTURE_SAMPLES / ((double) width * height)))));
    }

    /** Returns words such as "16 samples a pixel (--supersample 4)". */
    public String describe() {
        int most = side * side;
        return isAdaptive
                ? Text.format("%d or, where these differ, %d samples a pixel", side, most)
                : most == 1 ? "1 sample a pixel" : Text.format("%d samples a pixel (--supersample %d)", most, side);
    }

    /** Returns the column of the first sample in a row of a pixel's square; no two rows have the same. */
    private int firstColumn(int row) {
        return 2 * (row + 1) % (side + 1) - 1;
    }

    /** Returns the first samples of pixels, row by row; width and height count samples. */
    BitSet first(int width, int height) {
        BitSet first = new BitSet(width * height);
        for (int y = 0; y < height; y++) {
            for (int x = firstColumn(y % side); x < width; x += side) {
                first.set(y * width + x);
            }
        }
        return first;
    }

    /**
     * Copies the first samples of each pixel along their rows, so that each counts {@link #side} times.
     *
     * @param picture picture whose first samples are drawn
     * @return all samples of the pixels that need them
     */
    BitSet spread(ScenePicture picture, DisplayTransform display, SceneColor background) {
        BitSet needed = new BitSet(picture.width() * picture.height());
        double[] behind = background.light();
        double[] light = new double[CHANNELS - 1];
        for (int top = 0; top < picture.height(); top += side) {
            for (int left = 0; left < picture.width(); left += side) {
                double[] least = {1, 1, 1};
                double[] most = new double[CHANNELS - 1];
                for (int row = 0; row < side; row++) {
                    int begin = (top + row) * picture.width() + left;
                    int first = begin + firstColumn(row);
                    SceneDisplay.transform(picture.rgba(), CHANNELS * first, display, behind, light);
                    for (int c = 0; c < light.length; c++) {
                        least[c] = Math.min(least[c], Math.sqrt(light[c]));
                        most[c] = Math.max(most[c], Math.sqrt(light[c]));
                    }
                    for (int sample = begin; sample < begin + side; sample++) {
                        System.arraycopy(picture.rgba(), CHANNELS * first, picture.rgba(), CHANNELS * sample, CHANNELS);
                    }
                }
                if (differ(least, most)) {
                    for (int row = top; row < top + side; row++) {
                        needed.set(row * picture.width() + left, row * picture.width() + left + side);
                    }
                }
            }
        }
        return needed;
    }

    private static boolean differ(double[] least, double[] most) {
        return IntStream.range(0, least.length).anyMatch(c -> most[c] - least[c] > LEAST_DIFFERENCE);
    }
}
