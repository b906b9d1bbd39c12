package sunbeam.app.gpu.colours;

import java.util.function.LongConsumer;
import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.colourtable.KeptPages;
import sunbeam.precompute.colourtable.TableLevels;

/** By what levels of colours are made. */
public interface LevelSources {

    /** The levels. */
    TableLevels levels();

    /** Pages that are kept for later runs, to be closed by the caller; may be none. */
    default KeptPages kept() {
        return KeptPages.NONE;
    }

    /** Makes what all levels need, if they will need it: without effect on what they give. Any thread may do so. */
    default void prepare() {}

    /** Keeps for later runs what else was made on the way; takes part of a second, for when nobody waits. */
    default void settle() {}

    /**
     * A source of a level's colours, to be closed by the caller.
     *
     * @param level its number
     * @param done told, from any thread, how many more places are done
     */
    ColourSource open(int level, LongConsumer done);
}
