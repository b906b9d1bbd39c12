package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Map;

/** Tiles of levels (see {@link LevelBaking}) that are cached for later runs. One thread at a time. */
public interface CachedTiles extends AutoCloseable {
    /** Keeps nothing. */
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

    /** Those of some tiles of a level that are cached, as far as is known before they are read. */
    BitSet present(int level, BitSet tiles);

    /** Reads those of some tiles of a level that are cached; {@link LevelBaking#TILE_NUMBERS} each. */
    Map<Integer, byte[]> read(int level, BitSet tiles);

    /** Keeps tiles of a level, if they can be. */
    void keep(int level, Map<Integer, byte[]> tiles);

    /** Removes all, and keeps no more: what misses its tolerance is made, and told of, in each run. */
    void discard();

    @Override
    void close();
}
