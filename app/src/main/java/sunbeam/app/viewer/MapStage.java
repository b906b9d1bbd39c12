package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.BooleanSupplier;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.scene.TimedTiles;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.optics.Direction;

/** Draws the BRDF map beside the mesh, small first, interruptible at any tile. */
final class MapStage {
    static final int PREVIEW_SIZE = 48;
    static final int SIZE = 192;

    private final RenderContext context;
    private final TimedTiles tiles = new TimedTiles(System::nanoTime);

    MapStage(RenderContext context) {
        this.context = context;
    }

    /**
     * Draws a map.
     *
     * @param method the scene's, uploaded to this context
     * @param interrupted asked after every tile
     * @return null if it was interrupted
     */
    BufferedImage draw(UploadedTables method, Direction light, int size, BooleanSupplier interrupted) {
        try (BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size)) {
            List<Tile> blocks = Tile.cover(size, size, TimedTiles.LARGEST);
            if (!tiles.draw(blocks, interrupted, tile -> renderer.draw(light, tile))) {
                return null;
            }
            LinearPicture picture = renderer.picture();
            return picture.shown(new DisplayTransform(AutoExposure.of(picture), Tone.COMPRESS));
        }
    }
}
