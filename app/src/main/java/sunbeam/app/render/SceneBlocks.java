package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import jrtr.Tile;

/**
 * Blocks of a picture, one render target each: few and nearly equal, since each costs a pass over all vertices. They depend on the
 * picture's size alone, so that a pixel is equal bit for bit in any tile. The last blocks may be smaller.
 */
record SceneBlocks(int width, int height, int blockWidth, int blockHeight) {
    static final int MOST_PIXELS = 1 << 20;

    // All known cards with OpenGL 3.3 have render targets of this size.
    private static final int LONGEST_SIDE = 1 << 11;

    /** @param multiple samples along a pixel's side, which divide the picture's sides and those of all blocks */
    static SceneBlocks of(int width, int height, int multiple) {
        int blockWidth = part(width, LONGEST_SIDE, multiple);
        int blockHeight = part(height, Math.min(LONGEST_SIDE, MOST_PIXELS / blockWidth), multiple);
        return new SceneBlocks(width, height, blockWidth, blockHeight);
    }

    /** Returns the longest of few nearly equal parts of a side; one part more is taken if all are then equal and share buffers. */
    private static int part(int side, int longest, int multiple) {
        int units = side / multiple;
        int fewest = ceilDiv(units, longest / multiple);
        return multiple * ceilDiv(units, units % fewest != 0 && units % (fewest + 1) == 0 ? fewest + 1 : fewest);
    }

    /** Rounds up; for positive integers. */
    static int ceilDiv(int dividend, int divisor) {
        return (dividend + divisor - 1) / divisor;
    }

    /**
     * Part of a tile that lies in one block.
     *
     * @param block in pixels of the picture
     * @param inBlock the part, in pixels from the block's corner
     * @param x column of the piece in the tile
     * @param y row of the piece in the tile
     */
    record Piece(Tile block, Tile inBlock, int x, int y) {}

    /**
     * Returns tiles in pixels, block by block, at most {@code side} wide and high.
     *
     * @param samples number of this picture's pixels along the side of a pixel of the tiles
     */
    List<Tile> tiles(int samples, int side) {
        int columns = Math.max(1, blockWidth / samples);
        int rows = Math.max(1, blockHeight / samples);
        return Tile.whole(width / samples, height / samples).divide(columns, rows).stream()
                .flatMap(part -> part.divide(side).stream())
                .toList();
    }

    static List<Piece> split(int width, int height) {
        return of(width, height, 1).split(Tile.whole(width, height));
    }

    List<Piece> split(Tile tile) {
        List<Piece> pieces = new ArrayList<>();
        for (Tile block : Tile.whole(width, height).divide(blockWidth, blockHeight)) {
            int x0 = Math.max(tile.x(), block.x());
            int y0 = Math.max(tile.y(), block.y());
            int x1 = Math.min(tile.x() + tile.width(), block.x() + block.width());
            int y1 = Math.min(tile.y() + tile.height(), block.y() + block.height());
            if (x0 < x1 && y0 < y1) {
                Tile inBlock = new Tile(x0 - block.x(), y0 - block.y(), x1 - x0, y1 - y0);
                pieces.add(new Piece(block, inBlock, x0 - tile.x(), y0 - tile.y()));
            }
        }
        return pieces;
    }
}
