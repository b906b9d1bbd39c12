package sunbeam.app.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.scene.View;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.render.GeometryBuffer.Layout;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.precompute.errors.ErrorStatistics;

/**
 * A part of a scene in graphics memory, drawn in tiles of any size. A pixel depends on the scene, the picture's size and its position, bit
 * for bit, not on its tile. Belongs to its context's thread. Owns its uploads, not the context.
 */
public final class SceneSession implements AutoCloseable {
    /** In pixels: two of the blocks of 64 x 64 that llvmpipe gives to each processor. */
    public static final int TILE_SIDE = 128;

    /** Most lights of an environment in a moving picture, which has no shadow maps of them. */
    public static final int MOVING_LIGHTS = 8;

    private final RenderContext context;
    private final PackedShading shading;
    private final UploadedScene uploaded;
    private final boolean ownsUploaded;
    private SkinSurface skin;
    private SceneData data;
    private long meshNanoseconds;

    /** Uploads a part and its scene; throws {@link jrtr.GraphicsException} if the device has no room for it. */
    public SceneSession(RenderContext context, SceneData data) {
        this(context, new UploadedScene(context), true, session -> session.update(data));
    }

    /** Uploads a scene without its diffraction: until {@link #update(SceneData)} only {@link #body} can draw it. */
    public SceneSession(RenderContext context, Scene scene, SceneShape shape) {
        this(context, new UploadedScene(context), true, session -> {
            session.uploaded.upload(scene, shape);
            session.skin = new SkinSurface(context, Optional.empty());
        });
    }

    /** Uploads a further part of the scene of another session, which must be closed last or with this one. */
    private SceneSession(SceneSession first, SceneData data) {
        this(first.context, first.uploaded, false, session -> session.update(data));
    }

    private SceneSession(
            RenderContext context, UploadedScene uploaded, boolean ownsUploaded, Consumer<SceneSession> upload) {
        this.context = context;
        this.uploaded = uploaded;
        this.ownsUploaded = ownsUploaded;
        this.shading = new PackedShading(context);
        try {
            upload.accept(this);
        } catch (RuntimeException | Error failure) {
            close();
            throw failure;
        }
    }

    /** Uploads the parts of a scene, which share its meshes and textures. */
    public static List<SceneSession> all(RenderContext context, List<SceneData> parts) {
        SceneSession first = new SceneSession(context, parts.get(0));
        return Resource.orClose(() -> all(first, parts), first::close);
    }

    /** Uploads the parts of a scene, the first into a session, which the caller closes if that fails. */
    public static List<SceneSession> all(SceneSession first, List<SceneData> parts) {
        List<SceneSession> sessions = new ArrayList<>(List.of(first));
        first.update(parts.get(0));
        try {
            parts.stream().skip(1).forEach(part -> sessions.add(new SceneSession(first, part)));
            return List.copyOf(sessions);
        } catch (RuntimeException | Error failure) {
            sessions.subList(1, sessions.size()).forEach(SceneSession::close);
            throw failure;
        }
    }

    public SceneData data() {
        return data;
    }

    /** Callers may use the tables in this context until the next update. */
    public UploadedTables method() {
        return skin.method();
    }

    public Scene scene() {
        return data.scene();
    }

    /** Changes the scene; the same objects stay uploaded. Throws {@link jrtr.GraphicsException} without room and keeps the old scene. */
    public void update(SceneData next) {
        boolean sharesMethod = data != null && next.sharesMethod(data);
        SkinSurface nextSkin = sharesMethod ? skin : new SkinSurface(context, Optional.of(next));
        Resource.orClose(
                () -> {
                    uploaded.upload(next.scene(), next.shape());
                    return uploaded;
                },
                () -> closeUnlessSame(nextSkin, skin));
        closeUnlessSame(skin, nextSkin);
        skin = nextSkin;
        data = next;
    }

    private static void closeUnlessSame(SkinSurface surface, SkinSurface other) {
        if (surface != null && surface != other) {
            surface.close();
        }
    }

    /** Changes to another scene without upload. Throws IllegalArgumentException unless {@link SceneData#suits} allows it. */
    public void update(Scene next) {
        update(data.with(next));
    }

    /** Returns tiles block by block. Any other division draws the same picture; alternating between blocks is slower. */
    public static List<Tile> tiles(int width, int height, int samples) {
        return SceneBlocks.of(samples * width, samples * height, samples).tiles(samples, TILE_SIDE);
    }

    /**
     * Draws a part of a picture, for a scene that {@link SceneData#suits} allows.
     *
     * @throws IllegalStateException if a scheduler bakes tiles and one that the part reads is missing
     */
    public ScenePicture draw(DrawRequest request) {
        ScenePicture part = drawResident(request);
        if (PackedShading.isMissing(part.rgba())) {
            throw new IllegalStateException("a sample reads tiles that were not requested for it");
        }
        return part;
    }

    /** Draws from resident tiles. Pixels that need another show the body and have {@link PackedShading#MISSING_COVERAGE}. */
    ScenePicture drawResident(DrawRequest request) {
        if (!SceneSharing.sharesData(data.scene(), request.scene())) {
            throw new IllegalArgumentException(
                    "a scene with another mesh, patch, texture or method needs an update first");
        }
        return drawLook(own(request));
    }

    /** Returns a request whose scene has this part's look as current one. */
    private DrawRequest own(DrawRequest request) {
        return request.with(request.scene().at(data.look()));
    }

    private ScenePicture drawLook(DrawRequest request) {
        SkinGeometry geometry = uploaded.geometry(request.scene(), request.width(), request.height());
        LightList lights = lights(request);
        LightTexture inMemory = uploaded.lights(geometry, lights, false);
        Optional<Ground> ground = uploaded.ground(request.scene());
        ScenePicture picture = ScenePicture.empty(request.columns(request.tile()), request.rows(request.tile()));
        List<SceneBlocks.Piece> pieces = request.blocks().split(request.tile());
        for (SceneBlocks.Piece piece : pieces.stream().filter(request::draws).toList()) {
            float[] pixels = shading.shade(part(request, geometry, lights, inMemory, piece));
            ground.ifPresent(below -> below.fillUncovered(pixels, request, geometry, lights, inMemory, piece));
            var drawn = new ScenePicture(request.columns(piece.inBlock()), request.rows(piece.inBlock()), pixels);
            picture.put(drawn, piece.x() / request.across(), piece.y() / request.down());
        }
        return picture;
    }

    /** Light from all directions; empty for a scene with lights of its own. */
    private Optional<RadianceMap> environment() {
        return uploaded.environment();
    }

    /** Returns the lights of a request. */
    LightList lights(DrawRequest request) {
        LightList all = LightList.of(request.scene(), environment());
        return request.light().isPresent() ? all.only(request.light().getAsInt()) : all;
    }

    private PackedShading.Part part(
            DrawRequest request,
            SkinGeometry geometry,
            LightList lights,
            LightTexture inMemory,
            SceneBlocks.Piece piece) {
        GeometryBuffer buffer = drawn(Layout.FULL, geometry, piece.block());
        return new PackedShading.Part(skin, data, request, geometry, buffer, lights, inMemory, piece);
    }

    private GeometryBuffer drawn(Layout layout, SkinGeometry geometry, Tile block) {
        long start = System.nanoTime();
        GeometryBuffer buffer = uploaded.drawn(layout, geometry, block);
        meshNanoseconds += System.nanoTime() - start;
        return buffer;
    }

    /**
     * Adds footprints to the feedback. If interrupted, clears it and returns false.
     *
     * @param ofSome whether a sample of the pixels suffices: under many lights only some are drawn
     */
    private boolean addFeedback(List<DrawRequest> parts, boolean ofSome, BooleanSupplier interrupted) {
        // Backwards: the LRU cache keeps the geometry of parts that are drawn first.
        for (int i = parts.size() - 1; i >= 0; i--) {
            if (interrupted.getAsBoolean()) {
                virtualTexture().ifPresent(VirtualTexture::clearFeedback);
                return false;
            }
            DrawRequest request = own(parts.get(i));
            SkinGeometry geometry = uploaded.geometry(request.scene(), request.width(), request.height());
            LightList lights = lights(request);
            LightTexture inMemory = uploaded.lights(geometry, lights, false);
            for (SceneBlocks.Piece piece : request.blocks().split(request.tile())) {
                shading.addFeedback(part(request, geometry, lights, inMemory, piece), ofSome ? lights.count() : 1);
            }
        }
        return true;
    }

    /** Returns requests for the first samples of all {@link #tiles} of a picture. */
    public static List<DrawRequest> parts(Scene scene, int width, int height, PixelSamples samples) {
        return tiles(width, height, samples.side()).stream()
                .map(tile -> DrawRequest.first(scene, width, height, tile, samples))
                .toList();
    }

    /** Returns the table's errors at some samples of a picture; empty for methods without table. */
    public Optional<ErrorStatistics> tableErrors(Scene scene, int width, int height, PixelSamples samples) {
        return virtualTexture().map(tiles -> {
            tiles.clearFeedback();
            addFeedback(parts(scene, width, height, samples), true, () -> false);
            tiles.bakeFeedback(false);
            return tiles.errors();
        });
    }

    public Optional<VirtualTexture> virtualTexture() {
        return skin.virtualTexture();
    }

    /** Requests the tiles of a picture and of its metered one; may take seconds. Returns false if {@code interrupted}, polled per part. */
    public boolean request(int width, int height, PixelSamples samples, BooleanSupplier interrupted) {
        if (virtualTexture().isEmpty()) {
            return true;
        }
        VirtualTexture tiles = virtualTexture().get();
        tiles.clearRequest();
        // Finding the tiles of hundreds of lights takes longer than baking all of them.
        if (tiles.requestWhole(environment().isPresent())) {
            return true;
        }
        boolean isWhole =
                (tiles.hasCoarsest() || addFeedback(PartSum.meterParts(scene(), width, height), false, interrupted))
                        && addFeedback(parts(scene(), width, height, samples), false, interrupted);
        if (isWhole) {
            tiles.request();
        }
        return isWhole;
    }

    /** Time of all geometry passes of this session. */
    public long meshNanoseconds() {
        return meshNanoseconds;
    }

    /** Draws a picture in sRGB without baking tiles. The divisor reduces columns and rows and enlarges footprints. */
    public BufferedImage moving(int fullWidth, int fullHeight, double divisor, double exposure) {
        return body(scene(), (int) Math.ceil(fullWidth / divisor), (int) Math.ceil(fullHeight / divisor), exposure);
    }

    /** Draws a moving picture of a scene; without its diffraction before the first {@link #update(SceneData)}. */
    public BufferedImage body(Scene scene, int width, int height, double exposure) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        drawMoving(scene, image, exposure, 0);
        return image;
    }

    /** Draws a moving picture whose tiles have no edges: all of it reads the level that stands in for others where tiles are missing. */
    public BufferedImage still(int width, int height, double exposure) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int standIn = drawMoving(scene(), image, exposure, 0);
        while (standIn > 0) {
            standIn = drawMoving(scene(), image, exposure, standIn);
        }
        return image;
    }

    /** Draws a picture from a level on; returns the level that stands in for finer ones ({@link StandIns}). */
    private int drawMoving(Scene scene, BufferedImage image, double exposure, int leastLevel) {
        int width = image.getWidth();
        SkinGeometry geometry = uploaded.geometry(scene, width, image.getHeight());
        LightList list = LightList.moving(scene, environment());
        LightTexture lights = uploaded.lights(geometry, list, true);
        // Direct writes end Swing's acceleration, from which an image that is painted once gains nothing.
        int[] picture = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        StandIns standIns = new StandIns();
        for (SceneBlocks.Piece piece : SceneBlocks.split(width, image.getHeight())) {
            GeometryBuffer buffer = drawn(Layout.MOVING, geometry, piece.block());
            int[] part = skin.drawMoving(
                    scene, uploaded.ground(scene), geometry, list, lights, buffer, piece.block(), exposure, leastLevel);
            standIns.add(part);
            int columns = piece.inBlock().width();
            for (int row = 0; row < piece.inBlock().height(); row++) {
                System.arraycopy(part, row * columns, picture, (piece.y() + row) * width + piece.x(), columns);
            }
        }
        return standIns.level();
    }

    /** The patch's x axis, 3 values per pixel in world space, top row first; zeros without skin. */
    float[] patchDirections(int width, int height) {
        SkinGeometry geometry = uploaded.geometry(scene(), width, height);
        float[] directions = new float[3 * width * height];
        for (SceneBlocks.Piece piece : SceneBlocks.split(width, height)) {
            Tile part = piece.inBlock();
            float[] tangents = drawn(Layout.FULL, geometry, piece.block()).tangents(part);
            for (int i = 0; i < part.pixels(); i++) {
                int pixel = (piece.y() + i / part.width()) * width + piece.x() + i % part.width();
                System.arraycopy(tangents, 4 * i, directions, 3 * pixel, 3);
            }
        }
        return directions;
    }

    /** Returns the point under a pixel, from the top left; empty for background. The pixel must lie in the picture. */
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return uploaded.pick(scene(), new View.Area(width, height, new Tile(x, y, 1, 1)));
    }

    @Override
    public void close() {
        closeUnlessSame(skin, null);
        shading.close();
        if (ownsUploaded) {
            uploaded.close();
        }
    }
}
