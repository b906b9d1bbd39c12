package sunbeam.app.render;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import jrtr.Tile;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.method.TableMethod;

/** Converts a scene's linear samples to sRGB, with automatic exposure; the same for {@code render} and the viewer. */
public final class SceneDisplay {
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
        int samples = scene.method().type().equals(TableMethod.TYPE) ? TABLE_SAMPLES : 1;
        ScenePicture small = ScenePicture.empty(columns, rows);
        boolean isWhole = tiles.draw(Tile.cover(columns, rows, TimedTiles.LARGEST), interrupted, tile -> {
            ScenePicture part = parts.draw(
                    DrawRequest.ofPixels(scene, columns, rows, tile, samples).coarsest());
            small.put(part.reduced(samples), tile.x(), tile.y());
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
}
