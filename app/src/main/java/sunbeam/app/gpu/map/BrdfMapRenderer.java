package sunbeam.app.gpu.map;

import java.util.Optional;
import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import org.joml.Vector2f;
import org.joml.Vector3f;
import sunbeam.app.gpu.LoopLimit;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.optics.Direction;

/** Draws the BRDF map of one light direction, tile by tile, so that no draw takes seconds. */
public final class BrdfMapRenderer implements AutoCloseable {
    private final RenderContext context;
    private final UploadedTables method;
    private final ShaderProgram program;
    private final FloatTarget target;
    private final int size;
    private final double turn;

    public BrdfMapRenderer(RenderContext context, UploadedTables method, int size) {
        this(context, method, size, 0);
    }

    /**
     * Creates a renderer for a turned patch.
     *
     * @param size width and height of the map in pixels
     * @param turn turn of the patch about the normal in radians, counterclockwise
     */
    public BrdfMapRenderer(RenderContext context, UploadedTables method, int size, double turn) {
        this.context = context;
        this.method = method;
        this.size = size;
        this.turn = turn;
        this.program = method.program("brdf_map.frag");
        this.target = context.createFloatTarget("BRDF map", FloatTarget.Spec.color(size, size));
        program.set("mapSize", new Vector2f(size, size));
        program.set("patchTurn", new Vector2f((float) Math.cos(turn), (float) Math.sin(turn)));
    }

    /**
     * Draws the map.
     *
     * @param light towards the light
     * @param progress accepts the number of pixels of each finished tile
     * @return linear XYZ of rho, NaN outside the disc
     */
    public LinearPicture render(Direction light, LongConsumer progress) {
        draw(light, progress);
        return picture();
    }

    /** Draws the map and leaves it on the device. */
    public void draw(Direction light, LongConsumer progress) {
        MapTiles tiles = new MapTiles(size);
        double secondsPerPixel = Double.POSITIVE_INFINITY;
        for (Optional<Tile> tile = tiles.next(secondsPerPixel); tile.isPresent(); tile = tiles.next(secondsPerPixel)) {
            long start = System.nanoTime();
            draw(light, tile.get());
            long pixels = tile.get().pixels();
            secondsPerPixel = (System.nanoTime() - start) * 1e-9 / pixels;
            progress.accept(pixels);
        }
    }

    /** Draws a part of the map, waits for it and leaves it on the device. */
    public void draw(Direction light, Tile tile) {
        Direction inPatch = light.turned(-turn);
        program.set("lightDirection", new Vector3f((float) inPatch.x(), (float) inPatch.y(), (float) inPatch.z()));
        context.drawFullScreen(program, method.textures(), target, tile);
        context.finish();
    }

    /** Returns the drawn map: linear XYZ of rho, NaN outside the disc. */
    public LinearPicture picture() {
        return LinearPicture.ofRgba(size, size, LoopLimit.checked(target.read(0)));
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
}
