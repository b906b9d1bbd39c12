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
        parts.prepare(scene, supersample * size.width(), supersample * size.height(), supersample);
    }

    /**
     * Draws a scene that was prepared.
     *
     * @param progress told after every tile how many pixels are done
     */
    ScenePicture render(Scene scene, LongConsumer progress) {
        int width = supersample * size.width();
        int height = supersample * size.height();
        ScenePicture picture = ScenePicture.empty(size.width(), size.height());
        for (Tile tile : SceneSession.tiles(size.width(), size.height(), supersample)) {
            Tile fine = new Tile(
                    supersample * tile.x(),
                    supersample * tile.y(),
                    supersample * tile.width(),
                    supersample * tile.height());
            ScenePicture part = parts.draw(scene, width, height, fine);
            picture.put(part.reduced(supersample), tile.x(), tile.y());
            progress.accept(tile.pixels());
        }
        return picture;
    }
}
