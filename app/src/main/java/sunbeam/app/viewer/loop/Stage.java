package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import jrtr.ContextInfo;
import jrtr.Tile;
import sunbeam.app.scene.Pick;

/** What draws the newest state, in pictures of any quality; {@link RenderLoop} says which, and when. Belongs to the render thread. */
public interface Stage extends AutoCloseable {
    /**
     * A whole picture that is not final.
     *
     * @param image which may have fewer pixels than the window
     * @param divisor it has a divisor-th of the columns and rows, or of the samples of diffracted light along them
     * @param hasColors whether it shows diffracted light, not the body alone
     * @param exposure factor that was applied
     */
    record Preview(BufferedImage image, double divisor, boolean hasColors, double exposure) {}

    /**
     * The whole picture as {@code render} writes it.
     *
     * @param exposure factor that was applied
     */
    record Final(BufferedImage image, double exposure) {}

    /** Takes a part of the final picture. */
    interface PartListener {
        /** Another part is drawn, and so large a share of the picture with it. */
        void drawn(Tile tile, BufferedImage part, double shareDone);
    }

    ContextInfo info();

    /**
     * Goes over to a state; if that fails, the old one stays.
     *
     * @param arrived told, by any thread, that {@link #takeTiles} has something to take
     */
    void update(ViewState next, Runnable arrived);

    /** Whether something moves, which leaves the processors to what is drawn. */
    void interactive(boolean value);

    /** Takes over tiles of color tables that have been made; whether there was one. */
    boolean takeTiles();

    /** A picture of what moves, as good as there is time for; nothing where it was interrupted. */
    Optional<Preview> moving(BooleanSupplier interrupted);

    /** A picture with all pixels, by those tiles of a color table that there are; nothing by other methods, nor where there are none. */
    Optional<Preview> byTiles();

    /** By methods without tables: the next finer picture; nothing where the final one is next, or it was interrupted. */
    Optional<Preview> finer(BooleanSupplier interrupted);

    /** Share of the coarsest mip level that is there, 1 where nobody waits for one. */
    double coarsestShare();

    /** Requests the tiles that the final picture looks into; whether all were found, that is it was not interrupted. */
    boolean request(BooleanSupplier interrupted);

    /** Share of what was requested that is there, 1 where nothing is missing. */
    double requestedShare();

    /** Draws the final picture, whose tiles are all there; nothing where it was interrupted. */
    Optional<Final> refine(BooleanSupplier interrupted, PartListener drawn);

    /**
     * Has the BRDF map of the state drawn, if it is shown, in place of the one that is being drawn.
     *
     * @param isFinal else a small one at once, or none where that takes longer, as while something moves it mostly does
     * @param interrupted asked between its parts, if the caller waits for it
     * @param drawn handed maps, and whether they are final, by any thread; those of color tables come later
     */
    void map(ViewState state, boolean isFinal, BooleanSupplier interrupted, BiConsumer<BufferedImage, Boolean> drawn);

    /** The final picture is there: has tiles made that the next one may look into. */
    void prefetch();

    Optional<Pick> pick(int x, int y, int width, int height);

    /** How the nanostructure of the state lies, as strokes on nothing; see {@link sunbeam.app.scene.PatchStrokes}. */
    BufferedImage strokes(int width, int height);

    @Override
    void close();
}
