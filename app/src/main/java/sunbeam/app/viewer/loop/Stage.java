package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import jrtr.Tile;
import sunbeam.app.render.Pick;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;

/** Renderer of viewer states in several qualities, driven by {@link RenderLoop}. Used by the render thread only. */
public interface Stage extends AutoCloseable {

    /**
     * Description of the BRDF map beside the picture.
     *
     * @param light direction to the light, tangent frame
     * @param object index of the object among the scene's objects
     * @param region index of the map's patch among the object's patches
     * @param patch the map's patch; no map is drawn if the stage has another one by now
     */
    record MapRequest(Direction light, int object, int region, Patch patch) {}

    /**
     * Picture in less than final quality.
     *
     * @param divisor factor by which columns and rows are reduced, or (without color tables) the distance of diffraction samples in pixels
     * @param hasColors true if the picture shows diffracted light, not only the body
     * @param exposure factor by which XYZ was multiplied for display
     * @param secondsToFinal estimated time of the final picture; 0 if unknown
     * @param lights number of an environment's lights in a still scene; empty while it moves, and for a scene with lights of its own
     */
    record Preview(
            BufferedImage image,
            double divisor,
            boolean hasColors,
            double exposure,
            double secondsToFinal,
            OptionalInt lights) {}

    /**
     * Final picture, equal to the picture of {@code render}.
     *
     * @param lights number of an environment's lights; empty for a scene with lights of its own
     */
    record Final(BufferedImage image, double exposure, OptionalInt lights) {}

    interface PartListener {
        /** Receives a tile and the share of all pixels that are done, 0 to 1. */
        void drawn(Tile tile, BufferedImage part, double shareDone);
    }

    String renderer();

    /** Draws the first scene's body, before its patches and method are loaded; then nothing else has been drawn. */
    BufferedImage body(Scene scene, SceneShape shape, int width, int height);

    /** Switches to a state; if that fails, the old one stays. {@code arrived} is called, on any thread, when there are new tiles. */
    void update(ViewState next, Runnable arrived);

    /** Sets whether something moves; then drawing has priority over baking. */
    void interactive(boolean value);

    /** Uploads finished tiles of color tables; returns true if there were any. */
    boolean takeTiles();

    /** Draws a preview in the best quality that a frame's time budget allows; empty if interrupted. */
    Optional<Preview> moving(BooleanSupplier interrupted);

    /** Draws full resolution from the resident tiles; empty without color table and until the coarsest level is resident. */
    Optional<Preview> byTiles();

    /** Draws the next finer preview of a method without tables, or one under more lights of an environment; empty if only the final picture is finer, or if interrupted. */
    Optional<Preview> finer(BooleanSupplier interrupted);

    /** Resident share of the coarsest mip level; 1 for methods without tables. */
    double coarsestShare();

    /** Requests the tiles of the final picture; returns false if interrupted. */
    boolean request(BooleanSupplier interrupted);

    /** Resident share of the requested tiles. */
    double requestedShare();

    /** Draws the final picture, whose tiles are all resident; empty if interrupted. */
    Optional<Final> refine(BooleanSupplier interrupted, PartListener drawn);

    /**
     * Draws or queues the BRDF map by the scene's own method; replaces an unfinished map. A preview is omitted if it would delay the picture.
     *
     * @param drawn receives each map and true if it is final, on any thread; with color tables, after this method returns
     */
    void map(
            MapRequest request, boolean isFinal, BooleanSupplier interrupted, BiConsumer<BufferedImage, Boolean> drawn);

    /** Starts baking tiles that the next picture may need; called after the final picture. */
    void prefetch();

    Optional<Pick> pick(int x, int y, int width, int height);

    /** Returns {@link sunbeam.app.render.LineDrawings#strokes} on a transparent image. */
    BufferedImage strokes(int width, int height);

    @Override
    void close();
}
