package sunbeam.app.commands.render;

import java.awt.image.BufferedImage;
import java.util.function.LongConsumer;
import jrtr.Tile;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;
import sunbeam.precompute.color.DisplayTransform;

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

    /**
     * A frame.
     *
     * @param linear before exposure
     * @param image as a screen shows it
     */
    record Frame(ScenePicture linear, BufferedImage image, double exposure) {}

    /** The factor at which a scene is drawn that may leave it open. */
    double exposure(Scene scene) {
        return SceneDisplay.exposure(scene, parts, size.width(), size.height());
    }

    /** Makes the colors that a scene's picture looks into. */
    void prepare(Scene scene) {
        parts.prepare(scene, size.width(), size.height(), supersample);
    }

    /**
     * Draws a scene that was prepared.
     *
     * @param progress told after every tile how many pixels are done
     */
    Frame render(Scene scene, double exposure, LongConsumer progress) {
        ScenePicture picture = ScenePicture.empty(size.width(), size.height());
        BufferedImage image = new BufferedImage(size.width(), size.height(), BufferedImage.TYPE_INT_RGB);
        DisplayTransform display = scene.display(exposure);
        for (Tile tile : SceneSession.tiles(size.width(), size.height(), supersample)) {
            ScenePicture samples = parts.samples(scene, size.width(), size.height(), tile, supersample);
            picture.put(samples.reduced(supersample), tile.x(), tile.y());
            BufferedImage shown = SceneDisplay.image(samples, supersample, display, scene.background());
            image.getRaster().setDataElements(tile.x(), tile.y(), shown.getRaster());
            progress.accept(tile.pixels());
        }
        return new Frame(picture, image, exposure);
    }
}
