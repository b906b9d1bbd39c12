package sunbeam.app.render;

/** Counts pixels of a moving picture by the level that stands in for a finer one of which a tile is missing. */
final class StandIns {
    // Edges of tiles are not seen in this share of a picture's pixels or less, as along a rim.
    private static final double UNSEEN = 0.01;
    private static final int LEVELS = 256;

    private final int[] pixels = new int[LEVELS];
    private long count;

    /** @param argb the highest byte is 255 less the level (shaders/moving.frag), 255 without a stand-in */
    void add(int[] argb) {
        for (int pixel : argb) {
            pixels[LEVELS - 1 - (pixel >>> 24)]++;
        }
        count += argb.length;
    }

    /** Returns the coarsest level that stands in, but for one in {@link #UNSEEN} of the pixels; 0 for none. */
    int level() {
        int level = LEVELS - 1;
        for (long coarser = pixels[level]; level > 0 && coarser <= UNSEEN * count; coarser += pixels[level]) {
            level--;
        }
        return level;
    }
}
