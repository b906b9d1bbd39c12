package sunbeam.app.commands.render;

import java.util.function.LongConsumer;
import jrtr.Tile;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;

/** Draws whole pictures, tile by tile; each pixel is the mean of {@code supersample^2}. */
final class FrameRenderer {
    private final PartSum parts;
    private final PictureSize size;
    private final int supersample;

    FrameRenderer(PartSum parts, PictureSize size, int supersample) {
        this.parts = parts;
        this.size = size;
        this.supersample = supersample;
    }

    /** Makes the colours that a scene's picture looks into. */
    void prepare(Scene scene) {
        parts.prepare(scene, size.width(), size.height(), supersample);
    }

    /**
     * Draws a scene that was prepared.
     *
     * @param progress told after every tile how many pixels are done
     */
    ScenePicture render(Scene scene, LongConsumer progress) {
        ScenePicture picture = ScenePicture.empty(size.width(), size.height());
        for (Tile tile : SceneSession.tiles(size.width(), size.height(), supersample)) {
            ScenePicture part = parts.draw(scene, size.width(), size.height(), tile, supersample);
            picture.put(part, tile.x(), tile.y());
            progress.accept(tile.pixels());
        }
        return picture;
    }
}
