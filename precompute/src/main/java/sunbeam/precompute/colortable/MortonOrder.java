package sunbeam.precompute.colortable;

/** Morton order (G. M. Morton, 1966) of a square's cells: numbers interleave the bits of x and y, so that near numbers are near cells. */
public final class MortonOrder {
    private MortonOrder() {}

    /**
     * Returns the number of a cell.
     *
     * @param x column of the cell, 0 to 2^15 - 1
     * @param y row of the cell, 0 to 2^15 - 1
     */
    public static long number(int x, int y) {
        return spread(x) | (spread(y) << 1);
    }

    public static int x(int number) {
        int x = number & 0x55555555;
        x = (x | (x >>> 1)) & 0x33333333;
        x = (x | (x >>> 2)) & 0x0f0f0f0f;
        x = (x | (x >>> 4)) & 0x00ff00ff;
        return (x | (x >>> 8)) & 0xffff;
    }

    public static int y(int number) {
        return x(number >>> 1);
    }

    /** Inserts a zero between neighboring bits. */
    private static long spread(int value) {
        long bits = value;
        bits = (bits | (bits << 8)) & 0x00ff00ffL;
        bits = (bits | (bits << 4)) & 0x0f0f0f0fL;
        bits = (bits | (bits << 2)) & 0x33333333L;
        return (bits | (bits << 1)) & 0x55555555L;
    }
}
