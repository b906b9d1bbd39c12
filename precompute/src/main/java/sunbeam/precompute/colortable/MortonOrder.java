package sunbeam.precompute.colortable;

/**
 * Numbers of the cells of a square along G. M. Morton's curve (1966): the bits of x and y in turn. Cells whose numbers are near
 * each other lie near each other.
 */
public final class MortonOrder {
    private MortonOrder() {}

    /**
     * The number of a cell.
     *
     * @param x at least 0, below 2^15
     * @param y at least 0, below 2^15
     */
    public static long number(int x, int y) {
        return spread(x) | (spread(y) << 1);
    }

    /** x of the cell with a number; y is that of half the number. */
    public static int x(int number) {
        int x = number & 0x55555555;
        x = (x | (x >>> 1)) & 0x33333333;
        x = (x | (x >>> 2)) & 0x0f0f0f0f;
        x = (x | (x >>> 4)) & 0x00ff00ff;
        return (x | (x >>> 8)) & 0xffff;
    }

    /** y of the cell with a number. */
    public static int y(int number) {
        return x(number >>> 1);
    }

    /** Zeros between the bits. */
    private static long spread(int value) {
        long bits = value;
        bits = (bits | (bits << 8)) & 0x00ff00ffL;
        bits = (bits | (bits << 4)) & 0x0f0f0f0fL;
        bits = (bits | (bits << 2)) & 0x33333333L;
        return (bits | (bits << 1)) & 0x55555555L;
    }
}
