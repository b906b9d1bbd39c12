package sunbeam.app.render;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import jrtr.Tile;
import sunbeam.app.scene.Scene;

/**
 * Request to draw a tile of a scene's picture. Immutable.
 *
 * @param width samples per row of the whole picture
 * @param height rows of samples of the whole picture
 * @param tile tile to draw, in samples; inside the picture
 * @param samples samples along a pixel's side
 * @param across one of this many columns of samples is drawn
 * @param down the same for rows; if fewer than {@code across}, rows differ in the columns that are drawn
 * @param isCoarsest whether method {@code table} looks colors up in its coarsest level alone
 * @param chosen the tile's pixels that are drawn, row by row; empty for all
 * @param light index of the only light that is drawn; empty for all
 */
public record DrawRequest(
        Scene scene,
        int width,
        int height,
        Tile tile,
        int samples,
        int across,
        int down,
        boolean isCoarsest,
        Optional<BitSet> chosen,
        OptionalInt light) {
    /** Returns a request for all samples of a tile of pixels. */
    public static DrawRequest ofPixels(Scene scene, int width, int height, Tile tile, int samples) {
        return first(scene, width, height, tile, PixelSamples.uniform(samples));
    }

    static DrawRequest first(Scene scene, int width, int height, Tile tile, PixelSamples samples) {
        int side = samples.side();
        Tile inSamples = new Tile(side * tile.x(), side * tile.y(), side * tile.width(), side * tile.height());
        int across = side / samples.firstAcross();
        return new DrawRequest(
                scene,
                side * width,
                side * height,
                inSamples,
                side,
                across,
                1,
                false,
                Optional.empty(),
                OptionalInt.empty());
    }

    /** Returns a request for one light alone, or for all. */
    DrawRequest under(OptionalInt one) {
        return new DrawRequest(scene, width, height, tile, samples, across, down, isCoarsest, chosen, one);
    }

    DrawRequest with(Scene other) {
        return new DrawRequest(other, width, height, tile, samples, across, down, isCoarsest, chosen, light);
    }

    DrawRequest coarsest() {
        return new DrawRequest(scene, width, height, tile, samples, across, down, true, chosen, light);
    }

    DrawRequest only(BitSet pixels) {
        return new DrawRequest(
                scene, width, height, tile, samples, across, down, isCoarsest, Optional.of(pixels), light);
    }

    SceneBlocks blocks() {
        return SceneBlocks.of(width, height, samples);
    }

    /** Returns the column, in samples from the tile's left, of a drawn sample by its column and row among these. */
    int x(int column, int row) {
        return across * column + (across > down ? PixelSamples.firstColumn(row % across, across) : 0);
    }

    /** x and y count samples from the tile's top left. */
    boolean draws(int x, int y) {
        return chosen.isEmpty() || chosen.get().get(y / samples * (tile.width() / samples) + x / samples);
    }

    /** True if a sample of a piece of the tile is drawn. */
    boolean draws(SceneBlocks.Piece piece) {
        int columns = tile.width() / samples;
        int left = piece.x() / samples;
        int right = left + SceneBlocks.ceilDiv(piece.inBlock().width(), samples);
        int top = piece.y() / samples;
        return chosen.isEmpty()
                || IntStream.range(
                                top, top + SceneBlocks.ceilDiv(piece.inBlock().height(), samples))
                        .map(row -> row * columns)
                        .anyMatch(row -> chosen.get().nextSetBit(row + left) - row >= left
                                && chosen.get().nextSetBit(row + left) - row < right);
    }

    int columns(Tile part) {
        return SceneBlocks.ceilDiv(part.width(), across);
    }

    int rows(Tile part) {
        return SceneBlocks.ceilDiv(part.height(), down);
    }

    /** Side of the square that a drawn sample stands for, in samples. */
    double footprintScale() {
        return Math.sqrt(across * down);
    }

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
}
