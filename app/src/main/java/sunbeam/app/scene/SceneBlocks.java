package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import jrtr.Tile;

/**
 * How a picture is divided among render targets. Blocks depend on the picture's size alone, so that a pixel comes out the
 * same to the last bit in whatever tiles it is drawn.
 */
final class SceneBlocks {
    /** Width and height of a block; any OpenGL 3.3 has targets of this size. */
    static final int SIDE = 1024;

    private SceneBlocks() {}

    /**
     * The part of a tile that lies in one block.
     *
     * @param block in the picture
     * @param inBlock the piece, counted from the block's corner
     * @param x column of the piece in the tile
     * @param y row of the piece in the tile
     */
    record Piece(Tile block, Tile inBlock, int x, int y) {}

    /** The blocks' pieces that make up a tile. */
    static List<Piece> split(int width, int height, Tile tile) {
        List<Piece> pieces = new ArrayList<>();
        for (int top = tile.y() / SIDE * SIDE; top < tile.y() + tile.height(); top += SIDE) {
            for (int left = tile.x() / SIDE * SIDE; left < tile.x() + tile.width(); left += SIDE) {
                Tile block = new Tile(left, top, Math.min(SIDE, width - left), Math.min(SIDE, height - top));
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
