package sunbeam.app.render;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import jrtr.Tile;

/** Divides drawing into tiles of about {@link #BUDGET_NANOSECONDS}, judged by earlier tiles. Drawing a tile cannot be interrupted. */
public final class TimedTiles {
    public static final long BUDGET_NANOSECONDS = 40_000_000;

    /** Largest side of a tile, in pixels. */
    public static final int LARGEST = 128;

    public static final int COARSEST = 32;

    private static final int SMALLEST = 8;
    // Side of the squares in PackedShading, of which tiles have whole numbers.
    private static final int MULTIPLE = 4;
    // Per tile, so that one empty tile does not erase the largest time.
    private static final double DECAY = 0.9;

    private final LongSupplier clock;
    // Maximum of recent tiles; initially that of the thesis's shader on two processors.
    private double nanosecondsPerPixel = 120_000;
    // Mean of the last picture, including its empty pixels.
    private double averagePerPixel = nanosecondsPerPixel;

    /** @param clock in nanoseconds; may exclude work that does not depend on a tile's size */
    public TimedTiles(LongSupplier clock) {
        this.clock = clock;
    }

    /** Returns the largest tiles, for drawing without interruption. */
    public static TimedTiles large() {
        TimedTiles tiles = new TimedTiles(() -> 0);
        tiles.nanosecondsPerPixel = 0;
        return tiles;
    }

    /** Draws squares tile by tile. Polls {@code interrupted} before each; returns false if interrupted. */
    public boolean draw(List<Tile> squares, BooleanSupplier interrupted, Consumer<Tile> drawing) {
        long begun = clock.getAsLong();
        for (Tile square : squares) {
            for (Tile tile : square.divide(side())) {
                if (interrupted.getAsBoolean()) {
                    return false;
                }
                long start = clock.getAsLong();
                drawing.accept(tile);
                double perPixel = (double) (clock.getAsLong() - start) / tile.pixels();
                nanosecondsPerPixel = Math.max(perPixel, DECAY * nanosecondsPerPixel);
            }
        }
        averagePerPixel = (double) (clock.getAsLong() - begun)
                / squares.stream().mapToLong(Tile::pixels).sum();
        return true;
    }

    public double secondsPerPixel() {
        return 1e-9 * averagePerPixel;
    }

    /** Smallest power of two, up to {@link #COARSEST}, by which columns and rows are divided to draw a picture in time. */
    public int stride(int width, int height, long nanoseconds) {
        int stride = 1;
        while (stride < COARSEST
                && (double) width * height * averagePerPixel > (double) nanoseconds * stride * stride) {
            stride *= 2;
        }
        return stride;
    }

    /** A multiple of 4 from 8 to 128; a square of 128 is divided into tiles of about this side. */
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
