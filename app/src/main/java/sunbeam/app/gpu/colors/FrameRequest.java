package sunbeam.app.gpu.colors;

import java.util.List;

/**
 * The tiles of a color table that pictures need. Immutable.
 *
 * @param coarsest what every picture falls back on; made even while something moves
 * @param picture what a picture that stands still looks into
 * @param prefetched what the next picture may look into; nobody waits for it
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

    /** Most urgent first. */
    List<TileSet> byPriority() {
        return List.of(coarsest, picture, prefetched);
    }
}
