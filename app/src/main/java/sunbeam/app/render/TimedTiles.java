package sunbeam.app.render;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import jrtr.Tile;

/**
 * Cuts what is drawn into tiles, as large as can be drawn in {@link #BUDGET_NANOSECONDS} by what the last ones took: nothing interrupts
 * the drawing of a tile, and what comes in meanwhile waits for its end.
 */
public final class TimedTiles {
    /** Longest time that a tile is meant to take. */
    public static final long BUDGET_NANOSECONDS = 40_000_000;

    /** Tiles are cut from squares of this side. */
    public static final int LARGEST = 128;

    /** Coarsest of {@link #stride}. */
    public static final int COARSEST = 32;

    private static final int SMALLEST = 8;
    // The squares in which pixels are taken up.
    private static final int MULTIPLE = 4;
    // Empty tiles cost nothing; they must not make one forget at once what the covered ones cost.
    private static final double FORGETTING = 0.9;

    private final LongSupplier clock;
    // Of the costliest tiles lately; at first as by the thesis's shader on two processors.
    private double nanosecondsPerPixel = 120_000;
    // Of the last picture as a whole, with what is empty of it.
    private double averagePerPixel = nanosecondsPerPixel;

    /** @param clock in nanoseconds; may leave out what does not depend on a tile's size */
    public TimedTiles(LongSupplier clock) {
        this.clock = clock;
    }

    /** As large as can be, for whoever is not interrupted. */
    public static TimedTiles large() {
        TimedTiles tiles = new TimedTiles(() -> 0);
        tiles.nanosecondsPerPixel = 0;
        return tiles;
    }

    /**
     * Draws tiles, one after the other.
     *
     * @param interrupted asked before each
     * @return whether all were drawn
     */
    public boolean draw(List<Tile> blocks, BooleanSupplier interrupted, Consumer<Tile> drawing) {
        long begun = clock.getAsLong();
        for (Tile block : blocks) {
            for (Tile tile : block.divided(side())) {
                if (interrupted.getAsBoolean()) {
                    return false;
                }
                long start = clock.getAsLong();
                drawing.accept(tile);
                double taken = (double) (clock.getAsLong() - start) / tile.pixels();
                nanosecondsPerPixel = Math.max(taken, FORGETTING * nanosecondsPerPixel);
            }
        }
        averagePerPixel = (double) (clock.getAsLong() - begun)
                / blocks.stream().mapToLong(Tile::pixels).sum();
        return true;
    }

    /** The finest power of two by which a picture's columns and rows can be divided to be drawn in that time. */
    public int stride(int width, int height, long nanoseconds) {
        int stride = 1;
        while (stride < COARSEST
                && (double) width * height * averagePerPixel > (double) nanoseconds * stride * stride) {
            stride *= 2;
        }
        return stride;
    }

    /** Width and height of the next tiles, a multiple of 4 from 8 to 128, so that squares of 128 divide into them evenly. */
    private int side() {
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
