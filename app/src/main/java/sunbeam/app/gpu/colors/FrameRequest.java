package sunbeam.app.gpu.colors;

import java.util.List;

/**
 * The tiles of a color table that pictures need. Immutable.
 *
 * @param coarsest tiles that replace missing finer ones in every picture; baked even while something moves
 * @param picture tiles that the still picture reads
 * @param prefetched tiles that the next picture may read
 */
record FrameRequest(TileSet coarsest, TileSet picture, TileSet prefetched) {
    FrameRequest {
        coarsest = coarsest.copy();
        picture = picture.copy();
        prefetched = prefetched.copy();
    }

    static FrameRequest none(int levels) {
        TileSet none = TileSet.none(levels);
        return new FrameRequest(none, none, none);
    }

    List<TileSet> byPriority() {
        return List.of(coarsest, picture, prefetched);
    }
}
