package sunbeam.app.gpu.colors;

import java.util.BitSet;
import java.util.List;
import sunbeam.precompute.colortable.TileGrid;

/**
 * Which tiles of a table are made whether or not a pixel looks into them.
 *
 * @param coarsest all tiles of the coarsest level, of which a preview has some color everywhere; none where they are too many
 * @param prefetched coarse levels as a whole, so that whatever comes into view has colors at once
 * @param few all tiles of all levels, where they are few
 */
record WholeLevels(TileSet coarsest, TileSet prefetched, TileSet few) {
    // Some seconds of one processor.
    private static final int MOST_PREFETCHED = 6000;
    // A table of no more tiles than these is made as a whole: that takes less than to find out which tiles pixels look
    // into.
    private static final int FEW = 2000;

    static WholeLevels of(List<TileGrid> grids) {
        TileSet coarsest = TileSet.none(grids.size());
        TileSet prefetched = TileSet.none(grids.size());
        for (int level = grids.size() - 1; level >= 0; level--) {
            BitSet all = grids.get(level).reachable();
            if (prefetched.count() + all.cardinality() > MOST_PREFETCHED) {
                return new WholeLevels(coarsest, prefetched, TileSet.none(grids.size()));
            }
            prefetched.of(level).or(all);
            if (level == grids.size() - 1) {
                coarsest.of(level).or(all);
            }
        }
        return new WholeLevels(
                coarsest, prefetched, prefetched.count() <= FEW ? prefetched : TileSet.none(grids.size()));
    }
}
