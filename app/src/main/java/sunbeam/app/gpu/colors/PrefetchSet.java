package sunbeam.app.gpu.colors;

import java.util.BitSet;
import java.util.List;
import sunbeam.precompute.colortable.TileGrid;

/**
 * Tiles of a table that are baked without feedback.
 *
 * @param coarsest all tiles of the coarsest level, so that a preview has colors everywhere; none if they are too many
 * @param prefetched all tiles of coarse levels, so that parts that come into view have colors at once
 * @param isWhole true if all tiles of all levels are prefetched
 */
record PrefetchSet(TileSet coarsest, TileSet prefetched, boolean isWhole) {
    // Most prefetched tiles; baking them takes some seconds on one processor.
    private static final int MOST_PREFETCHED = 6000;
    // Most tiles of a table that is baked as a whole, which is then faster than finding the tiles that footprints
    // read.
    private static final int SMALL_TABLE = 2000;

    static PrefetchSet of(List<TileGrid> grids) {
        TileSet coarsest = TileSet.none(grids.size());
        TileSet prefetched = TileSet.none(grids.size());
        for (int level = grids.size() - 1; level >= 0; level--) {
            BitSet all = grids.get(level).reachable();
            if (prefetched.count() + all.cardinality() > MOST_PREFETCHED) {
                return new PrefetchSet(coarsest, prefetched, false);
            }
            prefetched.of(level).or(all);
            if (level == grids.size() - 1) {
                coarsest.of(level).or(all);
            }
        }
        return new PrefetchSet(coarsest, prefetched, true);
    }

    /** True if the table is baked as a whole. */
    boolean isSmall() {
        return isWhole && prefetched.count() <= SMALL_TABLE;
    }
}
