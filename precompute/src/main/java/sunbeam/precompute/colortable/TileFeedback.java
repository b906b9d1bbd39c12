package sunbeam.precompute.colortable;

import java.util.BitSet;

/** Marks the tiles that look-ups read; of some beside them too, where they fall close to their edges. Belongs to a thread. */
public final class TileFeedback {
    private final LevelGrid grid;
    private final BitSet tiles;
    private final int columns;
    private final double middle;
    private final double perStep;
    private final double perSliceStep;
    // What was marked last: look-ups of a pixel lie beside each other, most of them on the same tiles.
    private int left = -1;
    private int right;
    private int top;
    private int bottom;
    private int low;
    private int high;

    /** @param tiles takes the marks */
    public TileFeedback(LevelGrid grid, BitSet tiles) {
        this.grid = grid;
        this.tiles = tiles;
        // Once: pictures ask for some ten million.
        this.columns = grid.columns();
        this.middle = -grid.firstCoefficient() / grid.design().step();
        this.perStep = 1 / grid.design().step();
        this.perSliceStep = 1 / grid.design().sliceStep();
    }

    /** Marks what a look-up reads. */
    public void mark(double u, double v, double w) {
        double x = u * perStep + middle;
        double y = v * perStep + middle;
        double slice = -w * perSliceStep;
        int newLow = grid.firstSlice(slice - LevelGrid.ROUNDING);
        int newHigh = grid.firstSlice(slice + LevelGrid.ROUNDING) + TableDesign.TAPS;
        int newLeft = tile(x - LevelGrid.ROUNDING);
        int newRight = tile(x + LevelGrid.ROUNDING);
        int newTop = tile(y - LevelGrid.ROUNDING);
        int newBottom = tile(y + LevelGrid.ROUNDING);
        if (newLow == low
                && newHigh == high
                && newLeft == left
                && newRight == right
                && newTop == top
                && newBottom == bottom) {
            return;
        }
        low = newLow;
        high = newHigh;
        left = newLeft;
        right = newRight;
        top = newTop;
        bottom = newBottom;
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                for (int i = low; i < high; i++) {
                    tiles.set((i * columns + row) * columns + column);
                }
            }
        }
    }

    /** What lies beyond all (u, v), as a wide pixel's rim may, is looked up at the edge; so does the shader. */
    private int tile(double texel) {
        // As floors: what is below zero is cut off.
        return Math.max(1, Math.min(columns - 2, (int) (texel / LevelGrid.SIDE)));
    }
}
