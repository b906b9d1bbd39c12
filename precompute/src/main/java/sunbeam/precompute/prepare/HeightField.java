package sunbeam.precompute.prepare;

/**
 * Measured heights on their way through the steps.
 *
 * @param columns along x
 * @param rows from the top (largest y) down
 * @param pitchX distance of columns, metres
 * @param pitchY distance of rows, metres
 * @param heights metres, row by row from the top, NaN where missing; not to be written to
 */
public record HeightField(int columns, int rows, double pitchX, double pitchY, double[] heights) {
    public HeightField {
        if (heights.length != (long) columns * rows) {
            throw new IllegalArgumentException(heights.length + " heights for " + columns + " x " + rows);
        }
    }

    /** Extent along x, metres. */
    public double width() {
        return columns * pitchX;
    }

    /** Extent along y, metres. */
    public double height() {
        return rows * pitchY;
    }

    /** The same grid with other heights, which are taken over. */
    HeightField with(double[] others) {
        return new HeightField(columns, rows, pitchX, pitchY, others);
    }

    /** Height at a column (0 = left) and row (0 = top), metres; NaN or infinite where missing. */
    public double at(int column, int row) {
        return heights[row * columns + column];
    }

    /** Column to [-1, 1]; 0 where there is only one. */
    double relativeX(int column) {
        return columns == 1 ? 0 : 2.0 * column / (columns - 1) - 1;
    }

    /** Row to [-1, 1], downwards; 0 where there is only one. */
    double relativeY(int row) {
        return rows == 1 ? 0 : 2.0 * row / (rows - 1) - 1;
    }
}
