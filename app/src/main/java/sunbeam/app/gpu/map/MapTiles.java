package sunbeam.app.gpu.map;

import java.util.Optional;
import jrtr.Tile;

/**
 * Tiles in which a map is drawn, from top to bottom: small at first, then sized by the measured time per pixel. Tiles must not be too
 * small, since waiting for a draw takes as long as some thousand pixels of a fast method.
 */
final class MapTiles {
    // Side of the first tile, in pixels: four of llvmpipe's blocks of 64 x 64 pixels, each of which one processor
    // draws. With a method of 0.12 ms per pixel the tile takes two seconds.
    static final int SIDE = 128;

    // Target time of a tile. It may take five times as long: the first tiles are in the corners, whose pixels are
    // faster than those of the disc.
    private static final double BUDGET_SECONDS = 0.1;

    private final int size;
    private int left;
    private int top;
    private int height;

    MapTiles(int size) {
        this.size = size;
        this.height = Math.min(SIDE, size);
    }

    /** Returns the next tile, sized by the last one's seconds per pixel (infinity at first); empty after the last. */
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
