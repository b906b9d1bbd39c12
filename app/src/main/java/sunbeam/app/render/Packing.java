package sunbeam.app.render;

import jrtr.Tile;

/**
 * Where in a target scattered pixels are shaded. Software renderers run a shader on squares of 4 x 4 pixels at once and
 * give each processor squares of 64 x 64: pixels packed into full small squares, spread over several large ones, keep all
 * of them busy however few there are.
 *
 * @param count pixels, from 1 to {@link #MOST}
 * @param columns in use: as few large squares as the pixels fill in their first four rows
 * @param rows in use
 */
record Packing(int count, int columns, int rows) {
    /** Columns of the target: 16 large squares. */
    static final int COLUMNS = 1024;

    /** Rows of the target. */
    static final int ROWS = 32;

    /** Pixels that fit. */
    static final int MOST = COLUMNS * ROWS;

    private static final int SMALL = 4;
    private static final int LARGE = 64;

    static Packing of(int count) {
        if (count < 1 || count > MOST) {
            throw new IllegalArgumentException(count + " pixels are none or more than " + MOST);
        }
        int columns = LARGE * Math.min(COLUMNS / LARGE, divided(count, LARGE * SMALL));
        return new Packing(count, columns, SMALL * divided(count, SMALL * columns));
    }

    /** The part of the target that is in use. */
    Tile used() {
        return new Tile(0, ROWS - rows, columns, rows);
    }

    /** Number of a pixel's slot in the target, row by row from the bottom left, as {@code gl_FragCoord} counts. */
    int slot(int pixel) {
        return COLUMNS * row(pixel) + column(pixel);
    }

    /** Number of a pixel's slot in {@link #used} as it is read: row by row from the top left. */
    int read(int pixel) {
        return columns * (rows - 1 - row(pixel)) + column(pixel);
    }

    /** Sixteen successive pixels share a small square. */
    private int column(int pixel) {
        return SMALL * (pixel / (SMALL * SMALL) % (columns / SMALL)) + pixel % SMALL;
    }

    private int row(int pixel) {
        return SMALL * (pixel / (SMALL * columns)) + pixel / SMALL % SMALL;
    }

    private static int divided(int dividend, int divisor) {
        return (dividend + divisor - 1) / divisor;
    }
}
