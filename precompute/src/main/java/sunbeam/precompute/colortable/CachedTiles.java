package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Map;

/** Cache of the tiles of a table's levels (see {@link LevelBaking}); by default it has none. Not thread-safe. */
public interface CachedTiles extends AutoCloseable {
    CachedTiles NONE = new CachedTiles() {};

    /** Returns those of these tiles that are cached, as far as is known without reading them. */
    default BitSet present(int level, BitSet tiles) {
        return new BitSet();
    }

    /** Reads those of these tiles that are cached: {@link LevelBaking#TILE_NUMBERS} encoded numbers for each. */
    default Map<Integer, byte[]> read(int level, BitSet tiles) {
        return Map.of();
    }

    default void keep(int level, Map<Integer, byte[]> tiles) {}

    /** Removes all tiles and stores no more: a table that misses its tolerance is baked, with a warning, in each run. */
    default void discard() {}

    @Override
    default void close() {}
}
