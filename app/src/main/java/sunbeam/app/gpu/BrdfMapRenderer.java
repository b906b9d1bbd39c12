package sunbeam.app.gpu;

import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import sunbeam.app.picture.LinearPicture;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/** Draws BRDF maps of {@code size} pixels a side, tile by tile: no draw takes seconds. The patch's turn is in radians, counterclockwise. */
public record BrdfMapRenderer(
        RenderContext context, UploadedTables method, ShaderProgram program, FloatTarget target, int size, double turn)
        implements AutoCloseable {
    // Four of llvmpipe's blocks of 64 x 64 pixels, one per processor; two seconds at 0.12 ms per pixel.
    private static final int SIDE = 128;

    // Tiles in corners, which come first, are faster than the disc's: a tile may take five times as long.
    private static final double BUDGET_NANOSECONDS = 1e8;

    public BrdfMapRenderer {
        program.set("mapSize", (float) size, (float) size);
        program.set("patchTurn", (float) Math.cos(turn), (float) Math.sin(turn));
    }

    public BrdfMapRenderer(RenderContext context, UploadedTables method, int size, double turn) {
        this(
                context,
                method,
                method.program("brdf_map.frag"),
                context.createFloatTarget("BRDF map", FloatTarget.Spec.color(size, size)),
                size,
                turn);
    }

    /** Returns a map in linear XYZ of rho, NaN outside the disc; {@code progress} gets the number of pixels of each tile. */
    public LinearPicture render(Direction light, LongConsumer progress) {
        draw(light, progress);
        return picture();
    }

    /** Draws a map from top to bottom in tiles as large as the measured time allows: a draw costs as much as some thousand pixels. */
    public void draw(Direction light, LongConsumer progress) {
        double affordable = 0;
        int height;
        for (int top = 0; top < size; top += height) {
            int rows = (int) Math.min(size, affordable / size) / SIDE * SIDE;
            height = Math.min(Math.max(SIDE, rows), size - top);
            int width;
            for (int left = 0; left < size; left += width) {
                int rest = size - left;
                width = (double) rest * height <= affordable ? rest : Math.min(SIDE, rest);
                Tile tile = new Tile(left, top, width, height);
                long start = System.nanoTime();
                draw(light, tile);
                affordable = BUDGET_NANOSECONDS * tile.pixels() / (System.nanoTime() - start);
                progress.accept(tile.pixels());
            }
        }
    }

    /** Draws a tile of the map and waits for it. */
    public void draw(Direction light, Tile tile) {
        Direction inPatch = light.turned(-turn);
        program.set("lightDirection", (float) inPatch.x(), (float) inPatch.y(), (float) inPatch.z());
        context.drawFullScreen(program, method.textures(), target, tile);
        context.finish();
    }

    /** Returns the drawn map: linear XYZ of rho, NaN outside the disc. */
    public LinearPicture picture() {
        LinearPicture picture = new LinearPicture(size, size, new float[3 * size * size]);
        for (int top = 0; top < size; top += SIDE) {
            Tile rows = new Tile(0, top, size, Math.min(SIDE, size - top));
            picture.setRgba(top * size, UploadedTables.requireWholeSums(target.read(0, rows)));
        }
        return picture;
    }

    public int coveredPixels() {
        LinearPicture picture = picture();
        return (int) IntStream.range(0, size * size).filter(picture::covered).count();
    }

    @Override
    public void close() {
        target.close();
        program.close();
    }

    /** Directions at the centers of a BRDF map's pixels (shaders/brdf_map.frag). */
    public record DiscDirections(int size, Direction light) {

        /** Returns the direction of a pixel inside the disc, counted row by row from the top left. */
        public DirectionPair at(int pixel) {
            return new DirectionPair(light, Direction.ofDisc(x(pixel), y(pixel)));
        }

        public boolean covers(int pixel) {
            return x(pixel) * x(pixel) + y(pixel) * y(pixel) < 1;
        }

        private double x(int pixel) {
            return (2.0 * (pixel % size) + 1) / size - 1;
        }

        private double y(int pixel) {
            int row = pixel / size;
            return 1 - (2.0 * row + 1) / size;
        }
    }
}
