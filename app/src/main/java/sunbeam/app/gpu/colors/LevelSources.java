package sunbeam.app.gpu.colors;

import java.util.function.LongConsumer;
import sunbeam.precompute.colortable.CachedTiles;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.colortable.ColorTable;

/** By what levels of colors are made. */
public interface LevelSources {

    ColorTable table();

    /** Tiles that are cached for later runs, to be closed by the caller; may be none. */
    default CachedTiles cached() {
        return CachedTiles.NONE;
    }

    /** Makes what all levels need, if they will need it: without effect on what they give. Any thread may do so. */
    default void prepare() {}

    /** Takes a line about colors that miss their tolerance, from any thread. */
    default void warn(String line) {}

    /**
     * A source of a level's colors, to be closed by the caller.
     *
     * @param level its number
     * @param done told, from any thread, how many more places are done
     */
    ColorSource open(int level, LongConsumer done);

    /** As much of points of the patch alone, before any relief that all levels are averages over. */
    default ColorSource openPoints(LongConsumer done) {
        return open(0, done);
    }
}
