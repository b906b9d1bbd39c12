package sunbeam.app.viewer;

/**
 * How large the tiles of the final picture may be so that drawing one, which nothing interrupts, keeps no input waiting.
 * Immutable; each measured tile gives the next value.
 *
 * @param nanosecondsPerPixel of the costliest tiles lately
 */
public record TileSide(double nanosecondsPerPixel) {
    /** Longest time that a tile is meant to take: input waits for it, and then for a preview. */
    public static final long BUDGET_NANOSECONDS = 40_000_000;

    /** Tiles are cut from squares of this side. */
    public static final int LARGEST = 128;

    private static final int SMALLEST = 8;
    // The squares in which pixels are taken up.
    private static final int MULTIPLE = 4;
    // Empty tiles cost nothing; they must not make one forget at once what the covered ones cost.
    private static final double FORGETTING = 0.9;

    /** As slow as the thesis's shader on two processors: 0.12 ms a pixel. */
    public static TileSide first() {
        return new TileSide(120_000);
    }

    /** The estimate after a tile. */
    public TileSide after(long pixels, long nanoseconds) {
        return new TileSide(Math.max((double) nanoseconds / pixels, FORGETTING * nanosecondsPerPixel));
    }

    /** Width and height of the next tiles, a multiple of 4 from 8 to 128, so that squares of 128 divide into them evenly. */
    public int side() {
        int parts = 1;
        while (side(parts) > SMALLEST
                && (double) side(parts) * side(parts) * nanosecondsPerPixel > BUDGET_NANOSECONDS) {
            parts++;
        }
        return side(parts);
    }

    private static int side(int parts) {
        int side = (LARGEST + parts - 1) / parts;
        return Math.max(SMALLEST, (side + MULTIPLE - 1) / MULTIPLE * MULTIPLE);
    }
}
