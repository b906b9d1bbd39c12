package sunbeam.app.scene;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import jrtr.scene.PictureArea;
import jrtr.scene.SceneRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.precompute.colortable.FootprintErrors;

/**
 * A scene in graphics memory, drawn in parts of any size. A pixel depends on the scene, the picture's size and its place
 * alone, never on the tile it was drawn in: whoever draws the same scene in the same size gets the same picture, bit for
 * bit.
 *
 * <p>Belongs to its context's thread. The session owns all that it uploads, not the context.
 */
public final class SceneSession implements AutoCloseable {
    /** Side of the tiles that {@link #tiles} gives; llvmpipe shares out blocks of 64 x 64 pixels among processors. */
    public static final int TILE_SIDE = 128;

    private final RenderContext context;
    private final SceneRenderer renderer;
    // By whether shadows are part of them, since lights take turns.
    private final Map<Boolean, GeometryBuffers> buffers = new HashMap<>();
    private final MovingPictures moving;
    private final PackedShading shading;
    private final Picking picking;
    private final UploadedScene uploaded;
    private int samplesAcross = 1;
    private long meshNanoseconds;
    // Whose colors were made last.
    private Prepared prepared;

    private record Prepared(
            Optional<LevelTiles> levels, Scene scene, int width, int height, List<Tile> parts, int samples) {}

    /**
     * Uploads a scene.
     *
     * @throws jrtr.GraphicsException if the device has no room for it
     */
    public SceneSession(RenderContext context, SceneData data) {
        this(context, renderer -> new UploadedScene(context, renderer, data));
    }

    /** Uploads what a scene shows. Nothing can be drawn before its data have followed by {@link #update(SceneData)}. */
    SceneSession(RenderContext context, Scene scene, SceneShape shape) {
        this(context, renderer -> new UploadedScene(context, renderer, scene, shape));
    }

    private SceneSession(RenderContext context, Function<SceneRenderer, UploadedScene> upload) {
        this.context = context;
        this.renderer = new SceneRenderer(context);
        this.moving = new MovingPictures(context, renderer);
        this.shading = new PackedShading(context);
        this.picking = new Picking(context);
        this.uploaded = orClose(upload);
    }

    private UploadedScene orClose(Function<SceneRenderer, UploadedScene> upload) {
        try {
            return upload.apply(renderer);
        } catch (RuntimeException | OutOfMemoryError failure) {
            close();
            throw failure;
        }
    }

    public SceneData data() {
        return uploaded.data();
    }

    /** The method's tables, for others in this context to draw with until the next update. */
    public UploadedTables method() {
        return uploaded.skin().method();
    }

    public Scene scene() {
        return data().scene();
    }

    /**
     * Goes over to another scene, which is drawn from now on. Parts that are the same objects as before stay in graphics
     * memory. If it fails, the old scene stays.
     *
     * @throws jrtr.GraphicsException if the device has no room for it
     */
    public void update(SceneData next) {
        uploaded.update(next);
    }

    /**
     * Goes over to a scene that differs in light, camera, orientation, weights, rotation, exposure or background only:
     * nothing is uploaded.
     *
     * @throws IllegalArgumentException for a scene that {@link SceneData#suits} does not allow
     */
    public void update(Scene next) {
        update(data().with(next));
    }

    /**
     * The tiles of a picture, those of one block after the other as far as the sizes go; any other division draws the same
     * picture, but one that goes to and fro between blocks may take longer.
     *
     * @param supersample pixels drawn along a side of each pixel
     */
    public static List<Tile> tiles(int width, int height, int supersample) {
        return SceneBlocks.of(supersample * width, supersample * height).tiles(supersample, TILE_SIDE);
    }

    /**
     * Draws a part of a picture.
     *
     * @param width pixels per row of the whole picture
     * @param height rows of the whole picture
     * @param tile which part; inside the picture
     * @return as large as the tile
     */
    public ScenePicture draw(int width, int height, Tile tile) {
        ScenePicture part = draw(width, height, tile, 1);
        if (PackedShading.isMissing(part.rgba())) {
            throw new IllegalStateException("a pixel looks into colors that were not requested for it");
        }
        return part;
    }

    /** Draws each stride-th pixel and row (a power of two); where colors are not there yet, the body with coverage -1. */
    ScenePicture draw(int width, int height, Tile tile, int stride) {
        return ScenePicture.sum(underEachLight(() -> underOneLight(width, height, tile, stride)));
    }

    /** Does something with the scene under each of its lights. */
    private <T> List<T> underEachLight(Supplier<T> drawing) {
        SceneData whole = data();
        List<T> results = new ArrayList<>();
        try {
            for (int light = 0; light < whole.scene().lights(); light++) {
                update(whole.scene().underLight(light));
                results.add(drawing.get());
            }
        } finally {
            update(whole);
        }
        return results;
    }

    private ScenePicture underOneLight(int width, int height, Tile tile, int stride) {
        SkinGeometry geometry = uploaded.geometry(width, height, false);
        ScenePicture part = ScenePicture.empty(few(tile.width(), stride), few(tile.height(), stride));
        for (SceneBlocks.Piece piece : SceneBlocks.of(width, height).split(tile)) {
            Tile inBlock = piece.inBlock();
            GeometryBuffer buffer = drawn(geometry, piece);
            float[] pixels = shading.shade(uploaded.skin(), scene(), buffer, inBlock, stride, samplesAcross);
            uploaded.ground()
                    .ifPresent(ground ->
                            ground.under(pixels, scene(), geometry, piece.block(), inBlock, stride, samplesAcross));
            part.put(
                    new ScenePicture(few(inBlock.width(), stride), few(inBlock.height(), stride), pixels),
                    piece.x() / stride,
                    piece.y() / stride);
        }
        return part;
    }

    /** As many of so many pixels as each stride-th makes. */
    static int few(int pixels, int stride) {
        return (pixels + stride - 1) / stride;
    }

    /** So many samples along a side will be one pixel in the end; holds for all that is drawn from now on. */
    void drawSamples(int samples) {
        samplesAcross = samples;
    }

    private GeometryBuffer drawn(SkinGeometry geometry, SceneBlocks.Piece piece) {
        long start = System.nanoTime();
        GeometryBuffer buffer = buffers.computeIfAbsent(
                        geometry.shadowLight().isPresent(),
                        shaded -> new GeometryBuffers(context, renderer, GeometryLayout.FULL))
                .of(geometry, piece.block());
        meshNanoseconds += System.nanoTime() - start;
        return buffer;
    }

    /**
     * Makes all that parts of a picture look into, where the method's colors are made so: at once for all of them, which is
     * faster than when they are drawn. Without effect otherwise.
     *
     * @param width pixels per row of the whole picture
     * @param height rows of the whole picture
     * @param parts inside the picture
     * @param samples along a side of what will be one pixel in the end; holds for all that is drawn from now on
     */
    public void prepare(int width, int height, List<Tile> parts, int samples) {
        samplesAcross = samples;
        Prepared wanted = new Prepared(tiles(), scene(), width, height, parts, samples);
        if (tiles().isEmpty() || wanted.equals(prepared)) {
            return;
        }
        if (!tiles().get().hasWhole()) {
            note(width, height, parts, samples, () -> false);
            tiles().get().make();
        }
        prepared = wanted;
    }

    /** Whether all was noted; else nothing is. */
    private boolean note(int width, int height, List<Tile> parts, int samples, BooleanSupplier interrupted) {
        return !underEachLight(() -> noteUnderOneLight(width, height, parts, samples, interrupted))
                .contains(false);
    }

    private boolean noteUnderOneLight(
            int width, int height, List<Tile> parts, int samples, BooleanSupplier interrupted) {
        SkinGeometry geometry = uploaded.geometry(width, height, false);
        // The first come last: their geometry is still there when they are drawn next.
        for (int i = parts.size() - 1; i >= 0; i--) {
            if (interrupted.getAsBoolean()) {
                tiles().ifPresent(LevelTiles::forget);
                return false;
            }
            for (SceneBlocks.Piece piece : SceneBlocks.of(width, height).split(parts.get(i))) {
                shading.note(uploaded.skin(), scene(), drawn(geometry, piece), piece.inBlock(), samples);
            }
        }
        return true;
    }

    /**
     * The errors of its color tables at some samples of a picture that has been drawn; empty without tables.
     *
     * @param width pixels per row
     * @param height rows
     * @param samples along a pixel's side
     */
    public Optional<FootprintErrors> tableErrors(int width, int height, int samples) {
        int columns = samples * width;
        int rows = samples * height;
        List<Tile> all = tiles(columns, rows, 1);
        prepare(columns, rows, all, samples);
        if (tiles().isPresent()) {
            note(columns, rows, all, samples, () -> false);
        }
        return tiles().map(LevelTiles::errors);
    }

    public Optional<LevelTiles> tiles() {
        return uploaded.skin().levels();
    }

    /**
     * Requests all tiles that a picture and its meter look into; it may take seconds to find them.
     *
     * @param width pixels per row
     * @param height rows
     * @param samples along a pixel's side; holds for all that is drawn from now on
     * @param interrupted asked now and then
     * @return whether it was not interrupted
     */
    public boolean request(int width, int height, int samples, BooleanSupplier interrupted) {
        samplesAcross = samples;
        if (tiles().isEmpty()) {
            return true;
        }
        // Nearly all of them are the picture's, too, and whole levels take little more than some of their tiles.
        tiles().get().prefetch();
        Tile meter = SceneDisplay.meter(width, height);
        if (!noteSamples(meter.width(), meter.height(), SceneDisplay.TABLE_SAMPLES, interrupted)) {
            return false;
        }
        tiles().get().take();
        if (!tiles().get().hasWhole() && !noteSamples(width, height, samples, interrupted)) {
            return false;
        }
        tiles().get().request();
        return true;
    }

    private boolean noteSamples(int width, int height, int samples, BooleanSupplier interrupted) {
        List<Tile> fine = tiles(samples * width, samples * height, 1);
        return note(samples * width, samples * height, fine, samples, interrupted);
    }

    /** Time that has gone to the mesh so far; the rest goes to pixels. */
    public long meshNanoseconds() {
        return meshNanoseconds + moving.meshNanoseconds();
    }

    /** As {@link MovingPictures#draw}. */
    public BufferedImage moving(int fullWidth, int fullHeight, double divisor, double exposure) {
        return moving.draw(uploaded, fullWidth, fullHeight, divisor, exposure);
    }

    /** Where the patch's x points, 3 values a pixel in world space, top row first; zeros where there is no skin. */
    float[] patchDirections(int width, int height) {
        SkinGeometry geometry = uploaded.geometry(width, height, false);
        float[] directions = new float[3 * width * height];
        for (SceneBlocks.Piece piece : SceneBlocks.split(width, height)) {
            Tile part = piece.inBlock();
            float[] tangents = drawn(geometry, piece).tangents(part);
            for (int i = 0; i < part.pixels(); i++) {
                int pixel = (piece.y() + i / part.width()) * width + piece.x() + i % part.width();
                System.arraycopy(tangents, 4 * i, directions, 3 * pixel, 3);
            }
        }
        return directions;
    }

    /**
     * What a pixel of a picture shows.
     *
     * @param x columns to its left
     * @param y rows above it
     * @param width pixels per row of the whole picture
     * @param height rows of the whole picture
     * @return nothing where that is the background
     * @throws IllegalArgumentException if the pixel is outside
     */
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return picking.pick(
                scene(),
                uploaded.mesh(),
                uploaded.body(),
                renderer,
                new PictureArea(width, height, new Tile(x, y, 1, 1)));
    }

    @Override
    public void close() {
        if (uploaded != null) {
            uploaded.close();
        }
        picking.close();
        moving.close();
        shading.close();
        buffers.values().forEach(GeometryBuffers::close);
    }
}
