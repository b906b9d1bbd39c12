package sunbeam.app.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import jrtr.Tile;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.method.TableMethod;

/** Converts a scene's linear samples to sRGB, with automatic exposure; the same for {@code render} and the viewer. */
public final class SceneDisplay {
    private static final int CHANNELS = 4;
    /** Longer side, in pixels, of the picture that is metered for automatic exposure. */
    public static final int METER_SIDE = 160;

    /** Samples along a pixel's side of the metered picture by method table; other methods take one. */
    public static final int TABLE_SAMPLES = 2;

    private SceneDisplay() {}

    /**
     * Returns the scene's exposure if it is set, else the automatic exposure of a small picture with the ratio of sides of the whole. It
     * depends neither on the whole picture's size and samples nor on finer levels of a color table than the coarsest: a picture that is
     * refined level by level keeps its exposure.
     *
     * @param tiles division of the small picture into tiles by measured time
     * @param interrupted polled before each tile
     * @return empty if interrupted
     */
    public static OptionalDouble exposure(
            Scene scene, PartSum parts, int width, int height, TimedTiles tiles, BooleanSupplier interrupted) {
        if (scene.get(SceneSettings.EXPOSURE).isPresent()) {
            return scene.get(SceneSettings.EXPOSURE);
        }
        Tile meter = meter(width, height);
        int columns = meter.width();
        int rows = meter.height();
        PixelSamples samples = PixelSamples.uniform(scene.method().type().equals(TableMethod.TYPE) ? TABLE_SAMPLES : 1);
        ScenePicture small = ScenePicture.empty(columns, rows);
        boolean isWhole = tiles.draw(Tile.cover(columns, rows, TimedTiles.LARGEST), interrupted, tile -> {
            ScenePicture part = parts.draw(
                    DrawRequest.ofPixels(scene, columns, rows, tile, samples).coarsest());
            small.put(part.reduced(samples.side()), tile.x(), tile.y());
        });
        return isWhole ? OptionalDouble.of(LinearPicture.exposure(small.linear())) : OptionalDouble.empty();
    }

    static List<DrawRequest> meterParts(Scene scene, int width, int height) {
        Tile meter = meter(width, height);
        return SceneSession.parts(scene, meter.width(), meter.height(), PixelSamples.uniform(TABLE_SAMPLES)).stream()
                .map(DrawRequest::coarsest)
                .toList();
    }

    private static Tile meter(int width, int height) {
        double scale = METER_SIDE / (double) Math.max(width, height);
        return Tile.whole((int) Math.max(1, Math.round(scale * width)), (int) Math.max(1, Math.round(scale * height)));
    }

    /**
     * Returns the picture over its background, which is not exposed. Samples are transformed to display light before averaging, so that
     * thin bright lines keep their color and smooth edges.
     *
     * @param samples picture with {@code factor x factor} samples for each pixel
     * @return opaque sRGB
     */
    public static BufferedImage image(
            ScenePicture samples, int factor, DisplayTransform display, SceneColor background) {
        int width = samples.width() / factor;
        BufferedImage image = new BufferedImage(width, samples.height() / factor, BufferedImage.TYPE_INT_RGB);
        int[] rgb = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        double[] behind = background.light();
        IntStream.range(0, image.getHeight()).parallel().forEach(row -> {
            double[] light = new double[3];
            double[] sum = new double[3];
            int last = -1;
            for (int column = 0; column < width; column++) {
                sum[0] = sum[1] = sum[2] = 0;
                for (int sample = 0; sample < factor * factor; sample++) {
                    int y = row * factor + sample / factor;
                    int x = column * factor + sample % factor;
                    int from = CHANNELS * (y * samples.width() + x);
                    // All samples of a pixel that show the ground below the mesh are equal, so that one transform
                    // serves them.
                    if (last < 0 || !areEqual(samples.rgba(), last, from)) {
                        transform(samples.rgba(), from, display, behind, light);
                        last = from;
                    }
                    for (int c = 0; c < 3; c++) {
                        sum[c] += light[c];
                    }
                }
                for (int c = 0; c < 3; c++) {
                    sum[c] /= factor * factor;
                }
                rgb[row * width + column] = DisplayTransform.packed(sum);
            }
        });
        return image;
    }

    private static boolean areEqual(float[] rgba, int one, int other) {
        return rgba[one] == rgba[other]
                && rgba[one + 1] == rgba[other + 1]
                && rgba[one + 2] == rgba[other + 2]
                && rgba[one + 3] == rgba[other + 3];
    }

    /** Computes a sample's display light over the background; the sample's light is premultiplied by coverage. */
    static void transform(float[] rgba, int from, DisplayTransform display, double[] behind, double[] light) {
        float uncovered = Math.max(0, 1 - rgba[from + 3]);
        display.light(rgba, from, light);
        for (int c = 0; c < 3; c++) {
            light[c] = Math.min(1, light[c] + uncovered * behind[c]);
        }
    }
}
