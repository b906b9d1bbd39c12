package sunbeam.app.render;

import java.util.List;
import jrtr.Tile;
import sunbeam.app.scene.Scene;

/**
 * Request to draw a tile of a scene's picture. Immutable.
 *
 * @param scene scene with all its lights
 * @param width samples per row of the whole picture
 * @param height rows of samples of the whole picture
 * @param tile tile to draw, in samples; inside the picture
 * @param samples number of samples along a pixel's side
 * @param stride every stride-th sample of every stride-th row is drawn; a power of two
 * @param isCoarsest whether method {@code table} looks colors up in its coarsest level alone
 */
public record DrawRequest(Scene scene, int width, int height, Tile tile, int samples, int stride, boolean isCoarsest) {
    /** Returns a request for all samples of a tile of pixels. */
    public static DrawRequest ofPixels(Scene scene, int width, int height, Tile tile, int samples) {
        Tile inSamples =
                new Tile(samples * tile.x(), samples * tile.y(), samples * tile.width(), samples * tile.height());
        return new DrawRequest(scene, samples * width, samples * height, inSamples, samples, 1, false);
    }

    /** Returns one request per light; this request's picture is the sum of theirs. */
    List<DrawRequest> perLight() {
        return scene.perLight().stream().map(this::with).toList();
    }

    DrawRequest with(Scene other) {
        return new DrawRequest(other, width, height, tile, samples, stride, isCoarsest);
    }

    DrawRequest coarsest() {
        return new DrawRequest(scene, width, height, tile, samples, stride, true);
    }

    int columns() {
        return SceneBlocks.ceilDiv(tile.width(), stride);
    }

    int rows() {
        return SceneBlocks.ceilDiv(tile.height(), stride);
    }
}
