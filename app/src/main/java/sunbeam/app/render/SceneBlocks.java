package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import jrtr.Tile;

/**
 * How a picture is divided among render targets: into as few as can be, nearly equal blocks, since each of them costs a pass over all vertices.
 * They depend on the picture's size alone, so that a pixel comes out the same to the last bit in whatever tiles it is drawn.
 *
 * @param width pixels per row of the picture
 * @param height rows of the picture
 * @param blockWidth pixels per row of a block; fewer of the rightmost
 * @param blockHeight rows of a block; fewer of the lowest
 */
record SceneBlocks(int width, int height, int blockWidth, int blockHeight) {
    /** Pixels of a block at most. */
    static final int MOST_PIXELS = 1 << 20;

    // Any graphics card with OpenGL 3.3 has targets as wide and as high.
    private static final int LONGEST_SIDE = 1 << 11;

    static SceneBlocks of(int width, int height) {
        int blockWidth = part(width, LONGEST_SIDE);
        return new SceneBlocks(
                width, height, blockWidth, part(height, Math.min(LONGEST_SIDE, MOST_PIXELS / blockWidth)));
    }

    /** Of a side: the largest of its fewest nearly equal parts that are at most so long. */
    private static int part(int side, int longest) {
        int parts = (side + longest - 1) / longest;
        return (side + parts - 1) / parts;
    }

    /**
     * The part of a tile that lies in one block.
     *
     * @param block in the picture
     * @param inBlock the piece, counted from the block's corner
     * @param x column of the piece in the tile
     * @param y row of the piece in the tile
     */
    record Piece(Tile block, Tile inBlock, int x, int y) {}

    /** Tiles of the picture of so many samples along a pixel's side, in its pixels: those of one block after the other. */
    List<Tile> tiles(int samples, int side) {
        int columns = Math.max(1, blockWidth / samples);
        int rows = Math.max(1, blockHeight / samples);
        return Tile.whole(width / samples, height / samples).divided(columns, rows).stream()
                .flatMap(part -> part.divided(side).stream())
                .toList();
    }

    /** The blocks' pieces that make up a picture. */
    static List<Piece> split(int width, int height) {
        return of(width, height).split(Tile.whole(width, height));
    }

    /** The blocks' pieces that make up a tile. */
    List<Piece> split(Tile tile) {
        List<Piece> pieces = new ArrayList<>();
        for (int top = tile.y() / blockHeight * blockHeight; top < tile.y() + tile.height(); top += blockHeight) {
            for (int left = tile.x() / blockWidth * blockWidth; left < tile.x() + tile.width(); left += blockWidth) {
                Tile block =
                        new Tile(left, top, Math.min(blockWidth, width - left), Math.min(blockHeight, height - top));
                int x0 = Math.max(tile.x(), left);
                int y0 = Math.max(tile.y(), top);
                int x1 = Math.min(tile.x() + tile.width(), left + block.width());
                int y1 = Math.min(tile.y() + tile.height(), top + block.height());
                Tile inBlock = new Tile(x0 - left, y0 - top, x1 - x0, y1 - y0);
                pieces.add(new Piece(block, inBlock, x0 - tile.x(), y0 - tile.y()));
            }
        }
        return pieces;
    }
}
