package sunbeam.app.render;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import jrtr.Tile;
import sunbeam.app.scene.Scene;

/**
 * Request to draw a tile of a scene's picture. Immutable.
 *
 * @param scene scene with all its lights
 * @param width samples per row of the whole picture
 * @param height rows of samples of the whole picture
 * @param tile tile to draw, in samples; inside the picture
 * @param samples samples of a pixel
 * @param stride every stride-th sample of every stride-th row is drawn; a power of two
 * @param isCoarsest whether method {@code table} looks colors up in its coarsest level alone
 * @param chosen the samples of the tile that are drawn, row by row, without a stride; empty for all
 * @param footprintScale factor of the footprints' axes: side of the square that a sample stands for, in samples
 */
public record DrawRequest(
        Scene scene,
        int width,
        int height,
        Tile tile,
        PixelSamples samples,
        int stride,
        boolean isCoarsest,
        Optional<BitSet> chosen,
        double footprintScale) {
    /** Returns a request for all samples of a tile of pixels. */
    public static DrawRequest ofPixels(Scene scene, int width, int height, Tile tile, PixelSamples samples) {
        int side = samples.side();
        Tile inSamples = new Tile(side * tile.x(), side * tile.y(), side * tile.width(), side * tile.height());
        return new DrawRequest(scene, side * width, side * height, inSamples, samples, 1, false, Optional.empty(), 1);
    }

    /** Returns one request per light; this request's picture is the sum of theirs. */
    List<DrawRequest> perLight() {
        return scene.perLight().stream().map(this::with).toList();
    }

    DrawRequest with(Scene other) {
        return new DrawRequest(other, width, height, tile, samples, stride, isCoarsest, chosen, footprintScale);
    }

    DrawRequest coarsest() {
        return new DrawRequest(scene, width, height, tile, samples, stride, true, chosen, footprintScale);
    }

    DrawRequest only(BitSet samplesOfTile) {
        return only(samplesOfTile, 1);
    }

    private DrawRequest only(BitSet samplesOfTile, double scale) {
        return new DrawRequest(
                scene, width, height, tile, samples, stride, isCoarsest, Optional.of(samplesOfTile), scale);
    }

    /**
     * Returns the request for the samples that are drawn in any case. One in {@link PixelSamples#side} adaptive samples is drawn; their
     * footprints share the pixel's area.
     */
    DrawRequest first() {
        return samples.isAdaptive()
                ? only(samples.first(tile.width(), tile.height()), Math.sqrt(samples.side()))
                : this;
    }

    /** True if a sample is drawn; x and y count from the tile's top left. */
    boolean draws(int x, int y) {
        return chosen.isEmpty() || chosen.get().get(y * tile.width() + x);
    }

    int columns() {
        return SceneBlocks.ceilDiv(tile.width(), stride);
    }

    int rows() {
        return SceneBlocks.ceilDiv(tile.height(), stride);
    }
}
