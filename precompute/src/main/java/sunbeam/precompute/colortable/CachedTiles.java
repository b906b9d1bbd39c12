package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Map;

/** Cache of the tiles of a table's levels (see {@link LevelBaking}). Not thread-safe. */
public interface CachedTiles extends AutoCloseable {
    CachedTiles NONE = new CachedTiles() {
        @Override
        public BitSet present(int level, BitSet tiles) {
            return new BitSet();
        }

        @Override
        public Map<Integer, byte[]> read(int level, BitSet tiles) {
            return Map.of();
        }

        @Override
        public void keep(int level, Map<Integer, byte[]> tiles) {}

        @Override
        public void discard() {}

        @Override
        public void close() {}
    };

    /** Returns those of these tiles that are cached, as far as is known without reading them. */
    BitSet present(int level, BitSet tiles);

    /** Reads those of these tiles that are cached: {@link LevelBaking#TILE_NUMBERS} encoded numbers for each. */
    Map<Integer, byte[]> read(int level, BitSet tiles);

    void keep(int level, Map<Integer, byte[]> tiles);

    /** Removes all tiles and stores no more: a table that misses its tolerance is baked, with a warning, in each run. */
    void discard();

    @Override
    void close();
}
