package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import jrtr.ContextInfo;
import jrtr.Tile;
import sunbeam.app.render.Pick;

/** Renderer of viewer states in several qualities, driven by {@link RenderLoop}. Used by the render thread only. */
public interface Stage extends AutoCloseable {
    /**
     * Preview of the whole picture.
     *
     * @param image picture, possibly with fewer pixels than the window
     * @param divisor reduction of the columns and rows, or of the samples of diffracted light along them
     * @param hasColors true if it shows diffracted light, not only the body
     * @param exposure factor that was applied
     */
    record Preview(BufferedImage image, double divisor, boolean hasColors, double exposure) {}

    /**
     * Final picture, equal to that of {@code render}.
     *
     * @param exposure applied factor
     */
    record Final(BufferedImage image, double exposure) {}

    /** Listener for parts of the final picture. */
    interface PartListener {
        /** Receives a drawn part and the share of the picture that is done. */
        void drawn(Tile tile, BufferedImage part, double shareDone);
    }

    ContextInfo info();

    /**
     * Switches to a state; if that fails, the old state stays.
     *
     * @param arrived called, on any thread, when {@link #takeTiles} has new tiles
     */
    void update(ViewState next, Runnable arrived);

    /** Sets whether something moves; then drawing has priority over baking. */
    void interactive(boolean value);

    /** Uploads finished tiles of color tables; true if there was one. */
    boolean takeTiles();

    /** Draws a moving picture in the best quality within its time budget; empty if interrupted. */
    Optional<Preview> moving(BooleanSupplier interrupted);

    /** Draws a picture with all pixels from the resident tiles; empty for methods without tables and without any resident tile. */
    Optional<Preview> byTiles();

    /** Draws the next finer picture of a method without tables; empty if the final one is next, or if interrupted. */
    Optional<Preview> finer(BooleanSupplier interrupted);

    /** Returns the resident share of the coarsest mip level; 1 for methods without tables. */
    double coarsestShare();

    /** Requests the tiles of the final picture; false if interrupted. */
    boolean request(BooleanSupplier interrupted);

    /** Returns the resident share of the requested tiles; 1 if none is missing. */
    double requestedShare();

    /** Draws the final picture, whose tiles are all resident; empty if interrupted. */
    Optional<Final> refine(BooleanSupplier interrupted, PartListener drawn);

    /**
     * Draws or queues the BRDF map of the state if it is visible; replaces an unfinished one.
     *
     * @param isFinal false for a small preview only, which is left out if it would take too long
     * @param interrupted checked between parts while the caller waits
     * @param drawn receives maps, and whether they are final, on any thread; maps of color tables come later
     */
    void map(ViewState state, boolean isFinal, BooleanSupplier interrupted, BiConsumer<BufferedImage, Boolean> drawn);

    /** Starts baking tiles that the next picture may need; called after the final picture. */
    void prefetch();

    Optional<Pick> pick(int x, int y, int width, int height);

    /** Draws the nanostructure's orientation as strokes on a transparent image; see {@link sunbeam.app.render.PatchStrokes}. */
    BufferedImage strokes(int width, int height);

    @Override
    void close();
}
