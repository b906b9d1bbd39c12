package sunbeam.app.render;

import jrtr.Tile;

/**
 * Positions of scattered pixels in a compact target. Software renderers shade 4 x 4 pixels at once and give each processor squares of 64 x
 * 64: pixels packed into full small squares, spread over several large ones, keep all processors busy.
 *
 * @param count pixels, from 1 to {@link #MOST}
 * @param columns columns in use: one large square for every 256 pixels, which fill four of its rows, up to all 16 squares
 * @param rows rows in use, a multiple of 4
 */
record Packing(int count, int columns, int rows) {
    /** Columns of the target: 16 large squares. */
    static final int COLUMNS = 1024;

    /** Rows of the target. */
    static final int ROWS = 32;

    static final int MOST = COLUMNS * ROWS;

    private static final int SMALL = 4;
    private static final int LARGE = 64;

    static Packing of(int count) {
        if (count < 1 || count > MOST) {
            throw new IllegalArgumentException(count + " pixels are none or more than " + MOST);
        }
        int columns = LARGE * Math.min(COLUMNS / LARGE, SceneBlocks.ceilDiv(count, LARGE * SMALL));
        return new Packing(count, columns, SMALL * SceneBlocks.ceilDiv(count, SMALL * columns));
    }

    /** Returns the part of the target that is in use; its rows count from the top. */
    Tile used() {
        return new Tile(0, ROWS - rows, columns, rows);
    }

    /** Returns the index of a pixel's slot in the target, row by row from the bottom left, as {@code gl_FragCoord}. */
    int slot(int pixel) {
        return COLUMNS * row(pixel) + column(pixel);
    }

    /** Returns the index of a pixel's slot in {@link #used} as read back: row by row from the top left. */
    int indexInReadback(int pixel) {
        return columns * (rows - 1 - row(pixel)) + column(pixel);
    }

    /** Sixteen successive pixels share a small square. */
    private int column(int pixel) {
        return SMALL * (pixel / (SMALL * SMALL) % (columns / SMALL)) + pixel % SMALL;
    }

    private int row(int pixel) {
        return SMALL * (pixel / (SMALL * columns)) + pixel / SMALL % SMALL;
    }
}
