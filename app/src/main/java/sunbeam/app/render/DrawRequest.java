package sunbeam.app.render;

import java.util.BitSet;
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
}
