package sunbeam.precompute.colortable;

/** Morton order (G. M. Morton, 1966) of a square's cells: numbers interleave the bits of x and y, so that near numbers are near cells. */
public final class MortonOrder {
    private MortonOrder() {}

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
}
