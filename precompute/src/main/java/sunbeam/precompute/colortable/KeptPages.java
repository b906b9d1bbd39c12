package sunbeam.precompute.colortable;

import java.util.BitSet;
import java.util.Map;

/** Pages of levels (see {@link LevelBaking}) that are kept for later runs. One thread at a time. */
public interface KeptPages extends AutoCloseable {
    /** Keeps nothing. */
    KeptPages NONE = new KeptPages() {
        @Override
        public BitSet kept(int level, BitSet pages) {
            return new BitSet();
        }

        @Override
        public Map<Integer, byte[]> read(int level, BitSet pages) {
            return Map.of();
        }

        @Override
        public void keep(int level, Map<Integer, byte[]> pages) {}

        @Override
        public void close() {}
    };

    /** Those of some pages of a level that are kept, as far as is known before they are read. */
    BitSet kept(int level, BitSet pages);

    /** Reads those of some pages of a level that are kept; {@link LevelBaking#PAGE_NUMBERS} each. */
    Map<Integer, byte[]> read(int level, BitSet pages);

    /** Keeps pages of a level, if they can be. */
    void keep(int level, Map<Integer, byte[]> pages);

    @Override
    void close();
}
