package sunbeam.app.gpu.map;

import java.util.Optional;
import jrtr.Tile;

/**
 * The parts in which a map is drawn, from top to bottom: small at first, and as large as is soon done once it is known how long a
 * pixel takes. Each draw is waited for, which costs as much as some thousand pixels of a fast method.
 */
final class MapTiles {
    // llvmpipe shares out blocks of 64 x 64 pixels among processors, so a tile holds several. Of a method that takes
    // 0.12 ms a
    // pixel on two of them, a tile takes two seconds.
    static final int SIDE = 128;

    // The disc's pixels take longer than those of its corners, which come first: by up to five times.
    private static final double BUDGET_SECONDS = 0.1;

    private final int size;
    private int left;
    private int top;
    private int height;

    /** @param size width and height of the map, pixels */
    MapTiles(int size) {
        this.size = size;
        this.height = Math.min(SIDE, size);
    }

    /** The next part, whose size follows from the last one's seconds per pixel, or infinity; empty after the last. */
    Optional<Tile> next(double secondsPerPixel) {
        if (top >= size) {
            return Optional.empty();
        }
        double pixels = BUDGET_SECONDS / secondsPerPixel;
        if (left == 0) {
            int affordable = (int) Math.min(size, pixels / size) / SIDE * SIDE;
            height = Math.min(Math.max(SIDE, affordable), size - top);
        }
        int rest = size - left;
        int width = (double) rest * height <= pixels ? rest : Math.min(SIDE, rest);
        Tile tile = new Tile(left, top, width, height);
        left += width;
        if (left == size) {
            left = 0;
            top += height;
        }
        return Optional.of(tile);
    }
}
