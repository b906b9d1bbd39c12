package sunbeam.app.render;

import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import jrtr.scene.PictureArea;
import jrtr.scene.SceneRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.errors.ErrorStatistics;

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
    private long meshNanoseconds;
    // The parts whose tiles were made last.
    private Prepared prepared;

    private record Prepared(Optional<LevelTiles> tiles, List<DrawRequest> parts) {}

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
     * @return as large as the tile
     * @throws IllegalArgumentException for a scene that {@link SceneData#suits} does not allow
     * @throws IllegalStateException if a scheduler makes the colors and has not made those that the part reads
     */
    public ScenePicture draw(DrawRequest request) {
        ScenePicture part = drawResident(request);
        if (PackedShading.isMissing(part.rgba())) {
            throw new IllegalStateException("a sample reads tiles that were not requested for it");
        }
        return part;
    }

    /** As {@link #draw}, by what is resident: where a scheduler has not made the colors yet, the body with coverage -1. */
    ScenePicture drawResident(DrawRequest request) {
        if (!data().suits(request.scene())) {
            throw new IllegalArgumentException(
                    "a scene with another mesh, patch, texture or method needs an update first");
        }
        return ScenePicture.sum(
                request.perLight().stream().map(this::underOneLight).toList());
    }

    private ScenePicture underOneLight(DrawRequest request) {
        int stride = request.stride();
        SkinGeometry geometry = uploaded.geometry(request.scene(), request.width(), request.height(), false);
        Optional<Ground> ground = uploaded.ground(request.scene());
        ScenePicture part = ScenePicture.empty(request.columns(), request.rows());
        for (SceneBlocks.Piece piece :
                SceneBlocks.of(request.width(), request.height()).split(request.tile())) {
            Tile inBlock = piece.inBlock();
            float[] pixels = shading.shade(
                    uploaded.skin(), request.scene(), drawn(geometry, piece), inBlock, stride, request.samples());
            ground.ifPresent(below ->
                    below.under(pixels, request.scene(), geometry, piece.block(), inBlock, stride, request.samples()));
            part.put(
                    new ScenePicture(few(inBlock.width(), stride), few(inBlock.height(), stride), pixels),
                    piece.x() / stride,
                    piece.y() / stride);
        }
        return part;
    }

    /** Number of each stride-th of some pixels. */
    static int few(int pixels, int stride) {
        return (pixels + stride - 1) / stride;
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
     * Makes the tiles that some parts of one picture read, where the method has a table: all at once, which is faster than when the parts are
     * drawn. Without effect otherwise.
     */
    public void prepare(List<DrawRequest> parts) {
        Prepared wanted = new Prepared(tiles(), parts);
        if (tiles().isEmpty() || wanted.equals(prepared)) {
            return;
        }
        if (!tiles().get().hasWhole()) {
            note(parts, () -> false);
            tiles().get().make();
        }
        prepared = wanted;
    }

    /** Whether the tiles of all parts were noted; else none is. */
    private boolean note(List<DrawRequest> parts, BooleanSupplier interrupted) {
        int lights = parts.get(0).scene().lights();
        for (int light = 0; light < lights; light++) {
            // Backwards: the least lately used geometry goes first, and what is drawn first is still there then.
            for (int i = parts.size() - 1; i >= 0; i--) {
                if (interrupted.getAsBoolean()) {
                    tiles().ifPresent(LevelTiles::forget);
                    return false;
                }
                note(parts.get(i).perLight().get(light));
            }
        }
        return true;
    }

    private void note(DrawRequest part) {
        SkinGeometry geometry = uploaded.geometry(part.scene(), part.width(), part.height(), false);
        for (SceneBlocks.Piece piece :
                SceneBlocks.of(part.width(), part.height()).split(part.tile())) {
            shading.note(uploaded.skin(), part.scene(), drawn(geometry, piece), piece.inBlock(), part.samples());
        }
    }

    /** All parts of a picture. */
    public static List<DrawRequest> parts(Scene scene, int width, int height, int samples) {
        return tiles(width, height, samples).stream()
                .map(tile -> DrawRequest.ofPixels(scene, width, height, tile, samples))
                .toList();
    }

    /**
     * The errors of its color tables at some samples of a picture that has been drawn; empty without tables.
     *
     * @param width pixels per row
     * @param height rows
     * @param samples along a pixel's side
     */
    public Optional<ErrorStatistics> tableErrors(Scene scene, int width, int height, int samples) {
        if (tiles().isEmpty()) {
            return Optional.empty();
        }
        List<DrawRequest> all = parts(scene, width, height, samples);
        prepare(all);
        note(all, () -> false);
        return tiles().map(LevelTiles::errors);
    }

    public Optional<LevelTiles> tiles() {
        return uploaded.skin().levels();
    }

    /**
     * Requests all tiles that a picture and its meter read; it may take seconds to find them.
     *
     * @param width pixels per row
     * @param height rows
     * @param samples along a pixel's side
     * @param interrupted asked now and then
     * @return whether it was not interrupted
     */
    public boolean request(int width, int height, int samples, BooleanSupplier interrupted) {
        if (tiles().isEmpty()) {
            return true;
        }
        // Nearly all of them are the picture's, too, and whole levels take little more than some of their tiles.
        tiles().get().prefetch();
        Tile meter = SceneDisplay.meter(width, height);
        if (!note(parts(scene(), meter.width(), meter.height(), SceneDisplay.TABLE_SAMPLES), interrupted)) {
            return false;
        }
        tiles().get().take();
        if (!tiles().get().hasWhole() && !note(parts(scene(), width, height, samples), interrupted)) {
            return false;
        }
        tiles().get().request();
        return true;
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
        SkinGeometry geometry = uploaded.geometry(scene(), width, height, false);
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
