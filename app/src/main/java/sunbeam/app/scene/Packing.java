package sunbeam.app.scene;

/**
 * Where in a target scattered pixels are shaded. Software renderers run a shader on squares of 4 x 4 pixels at once and
 * give each processor squares of 64 x 64: pixels packed into full small squares, spread over several large ones, keep all
 * of them busy however few there are. Slots count as {@code gl_FragCoord} does, from the bottom left.
 *
 * @param count pixels, from 1 to {@link #MOST}
 */
record Packing(int count) {
    /** Columns of the target: 16 large squares. */
    static final int COLUMNS = 1024;

    static final int ROWS = 32;

    static final int MOST = COLUMNS * ROWS;

    private static final int SMALL = 4;
    private static final int LARGE = 64;

    /** Columns in use: as few large squares as the pixels fill in their first four rows. */
    int columns() {
        return LARGE * Math.min(COLUMNS / LARGE, divided(count, LARGE * SMALL));
    }

    int rows() {
        return SMALL * divided(count, SMALL * columns());
    }

    /** Column of a pixel's slot; sixteen successive pixels share a small square. */
    int column(int pixel) {
        return SMALL * (pixel / (SMALL * SMALL) % (columns() / SMALL)) + pixel % SMALL;
    }

    int row(int pixel) {
        return SMALL * (pixel / (SMALL * columns())) + pixel / SMALL % SMALL;
    }

    private static int divided(int dividend, int divisor) {
        return (dividend + divisor - 1) / divisor;
    }
}
