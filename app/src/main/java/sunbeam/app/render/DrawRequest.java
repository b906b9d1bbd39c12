package sunbeam.app.render;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.Tile;
import sunbeam.app.scene.Scene;

/**
 * A part of a picture of a scene. Immutable.
 *
 * @param scene under all its lights
 * @param width samples per row of the whole picture
 * @param height rows of samples of the whole picture
 * @param tile the part, in samples; inside the picture
 * @param samples along a side of what will be one pixel
 * @param stride each stride-th sample of each stride-th row is drawn, a power of two; 1 for all
 */
public record DrawRequest(Scene scene, int width, int height, Tile tile, int samples, int stride) {
    /**
     * A request for all samples of a tile of pixels.
     *
     * @param width pixels per row of the whole picture
     * @param height rows of the whole picture
     * @param tile in pixels
     * @param samples along a pixel's side
     */
    public static DrawRequest ofPixels(Scene scene, int width, int height, Tile tile, int samples) {
        Tile fine = new Tile(samples * tile.x(), samples * tile.y(), samples * tile.width(), samples * tile.height());
        return new DrawRequest(scene, samples * width, samples * height, fine, samples, 1);
    }

    /** One request a light, whose pictures add up to this one's. */
    List<DrawRequest> perLight() {
        return IntStream.range(0, scene.lights())
                .mapToObj(light -> with(scene.underLight(light)))
                .toList();
    }

    /** The same part of another scene. */
    DrawRequest with(Scene other) {
        return new DrawRequest(other, width, height, tile, samples, stride);
    }

    /** Samples drawn per row. */
    int columns() {
        return SceneSession.few(tile.width(), stride);
    }

    /** Rows of samples drawn. */
    int rows() {
        return SceneSession.few(tile.height(), stride);
    }
}
