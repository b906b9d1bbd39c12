package sunbeam.app.viewer;

/**
 * How large the tiles of the final picture may be so that drawing one, which nothing interrupts, keeps no input waiting.
 * Immutable; each measured tile gives the next value.
 *
 * @param nanosecondsPerPixel of the costliest tiles lately
 */
public record TileSide(double nanosecondsPerPixel) {
    /** Longest time that a tile is meant to take: input waits for it, and then for a preview. */
    public static final long BUDGET_NANOSECONDS = 20_000_000;

    /** Tiles are cut from squares of this side. */
    public static final int LARGEST = 128;

    private static final int SMALLEST = 8;
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

    /** Width and height of the next tiles, a power of two from 8 to 128. */
    public int side() {
        int side = LARGEST;
        while (side > SMALLEST && side * side * nanosecondsPerPixel > BUDGET_NANOSECONDS) {
            side /= 2;
        }
        return side;
    }
}
