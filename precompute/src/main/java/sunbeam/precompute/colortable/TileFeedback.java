package sunbeam.precompute.colortable;

import java.util.BitSet;

/** Marks the tiles that look-ups read in a color table of all lights. Not thread-safe. */
public final class TileFeedback {
    private final TileGrid grid;
    private final BitSet tiles;
    private final int columns;
    private final int rows;
    private final double firstX;
    private final double firstY;
    private final double perStep;
    private final double perSliceStep;
    // Most look-ups of a pixel read the same tiles as the last one.
    private int left = -1;
    private int right;
    private int top;
    private int bottom;
    private int firstSlice;
    private int endSlice;

    /** @param tiles receives a bit for each marked tile */
    public TileFeedback(TileGrid grid, BitSet tiles) {
        this.grid = grid;
        this.tiles = tiles;
        // Copies of the grid's values, for speed: pictures mark some ten million look-ups.
        this.columns = grid.columns();
        this.rows = grid.rows();
        this.perStep = 1 / grid.design().step();
        this.firstX = grid.firstX() * perStep;
        this.firstY = grid.firstY() * perStep;
        this.perSliceStep = 1 / grid.design().sliceStep();
    }

    /** Marks the tiles of a look-up, and their neighbors within rounding of an edge. */
    public void mark(double u, double v, double w) {
        double x = u * perStep - firstX;
        double y = v * perStep - firstY;
        double slicePosition = -w * perSliceStep;
        int newFirstSlice = grid.firstSlice(slicePosition - TileGrid.ROUNDING);
        int newEndSlice = grid.firstSlice(slicePosition + TileGrid.ROUNDING) + TableDesign.TAPS;
        int newLeft = tile(x - TileGrid.ROUNDING, columns);
        int newRight = tile(x + TileGrid.ROUNDING, columns);
        int newTop = tile(y - TileGrid.ROUNDING, rows);
        int newBottom = tile(y + TileGrid.ROUNDING, rows);
        if (newFirstSlice == firstSlice
                && newEndSlice == endSlice
                && newLeft == left
                && newRight == right
                && newTop == top
                && newBottom == bottom) {
            return;
        }
        firstSlice = newFirstSlice;
        endSlice = newEndSlice;
        left = newLeft;
        right = newRight;
        top = newTop;
        bottom = newBottom;
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                for (int slice = firstSlice; slice < endSlice; slice++) {
                    tiles.set((slice * rows + row) * columns + column);
                }
            }
        }
    }

    /** Clamps to the tiles inside the grid's border, as in the shader, since wide footprints may exceed them. */
    private static int tile(double texel, int count) {
        // Casts are floors, since negative values are clamped.
        return Math.max(1, Math.min(count - 2, (int) (texel / TileGrid.SIDE)));
    }
}
