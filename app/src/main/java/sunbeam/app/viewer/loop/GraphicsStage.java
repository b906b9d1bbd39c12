package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.render.LightCount;
import sunbeam.app.render.LineDrawings;
import sunbeam.app.render.Pick;
import sunbeam.app.render.PixelPicture;
import sunbeam.app.render.PixelSamples;
import sunbeam.app.render.SceneSession;
import sunbeam.app.render.SceneShape;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.model.Background;

/** Renderer of viewer states by OpenGL: owns the context, both methods' sessions and the drawing of the BRDF map. */
public final class GraphicsStage implements Stage {
    // Longest wait, after the window closes, for a running evaluation of table colors.
    private static final long PATIENCE_MILLISECONDS = 5000;
    // Time budget for the diffracted light of a moving preview without tables; the body takes about as long.
    private static final long MOVING_NANOSECONDS = 400_000_000;
    // Sample stride, in pixels, of the last coarse picture before the final one.
    private static final int FINEST_STRIDE = 4;
    // Factor by which each preview of a still scene has more lights of an environment than the one before.
    private static final int MORE_LIGHTS = 4;
    // Sample stride of the comparison's first picture. Nothing moves then, and a newer state interrupts it.
    private static final int COMPARISON_STRIDE = 8;

    private final RenderContext context = RenderContext.offscreen();
    private final MapStage map = new MapStage(context);
    // One thread, since a color source may be bound to the thread that created it.
    private final Background baking = new Background("colors");
    private final CachedExposure exposures = new CachedExposure();
    // Lights of the environment, and the scene for which they were counted; other views of it have as many.
    private Optional<LightCount> count = Optional.empty();
    private Scene countedFor;
    private final StageSessions own = new StageSessions(context);
    private final StageSessions other = new StageSessions(context);
    private StageSessions current = own;
    private int stride;
    // Lights of an environment in the last preview.
    private int lights;
    private ViewState state;
    private boolean isMoving;

    @Override
    public String renderer() {
        return context.info().renderer();
    }

    @Override
    public BufferedImage body(Scene scene, SceneShape shape, int width, int height) {
        return own.open(scene, shape).body(scene, width, height, exposures.soFar(scene, 0));
    }

    @Override
    public void update(ViewState next, Runnable arrived) {
        StageSessions sessions = next.isOther() ? other : own;
        sessions.update(next.scene().parts());
        current = sessions;
        state = next;
        current.colors().forEach(colors -> colors.bakeOn(baking, arrived));
    }

    @Override
    public void interactive(boolean value) {
        isMoving = value;
        // A picture by the comparison method neither cancels nor delays the map, which belongs to the scene's own
        // method.
        if (value && state.isOther()) {
            other.colors().forEach(colors -> colors.interactive(true));
            return;
        }
        // Both methods share the processors.
        Stream.concat(own.colors(), other.colors()).forEach(colors -> colors.interactive(value));
        if (value) {
            map.cancel();
        }
    }

    @Override
    public boolean takeTiles() {
        return current.colors().map(VirtualTexture::drain).reduce(false, Boolean::logicalOr);
    }

    @Override
    public boolean request(BooleanSupplier interrupted) {
        return current.parts.stream()
                .allMatch(part -> part.request(state.width(), state.height(), samples(), interrupted));
    }

    @Override
    public double requestedShare() {
        return current.colors()
                .mapToDouble(VirtualTexture::requestedShare)
                .average()
                .orElse(1);
    }

    @Override
    public double coarsestShare() {
        return current.colors()
                .mapToDouble(VirtualTexture::coarsestShare)
                .average()
                .orElse(1);
    }

    @Override
    public void prefetch() {
        current.colors().forEach(VirtualTexture::validate);
        current.colors().forEach(VirtualTexture::prefetch);
    }

    /** A picture of several tables (looks, patches, Fresnel components) is previewed like a method without tables. */
    private boolean isByTable() {
        return current.parts.size() == 1 && current.colors().findAny().isPresent();
    }

    private boolean hasCoarsest() {
        return current.colors().allMatch(VirtualTexture::hasCoarsest);
    }

    @Override
    public Optional<Preview> moving(BooleanSupplier interrupted) {
        lights = SceneSession.MOVING_LIGHTS;
        if (isByTable()) {
            long start = current.pixelClock();
            Preview preview = byTable(current.scale.divisor(), false);
            current.scale.frame(current.pixelClock() - start);
            return Optional.of(preview);
        }
        if (state.isOther()) {
            stride = COMPARISON_STRIDE;
            return coarse(interrupted);
        }
        stride = current.tiles.stride(state.width(), state.height(), MOVING_NANOSECONDS);
        long start = System.nanoTime();
        // If a picture takes twice its budget, draw it again with the fewest samples.
        Optional<Preview> preview = coarse(() -> interrupted.getAsBoolean()
                || (stride < TimedTiles.COARSEST && System.nanoTime() - start > 2 * MOVING_NANOSECONDS));
        if (preview.isPresent() || interrupted.getAsBoolean()) {
            return preview;
        }
        stride = TimedTiles.COARSEST;
        return coarse(interrupted);
    }

    @Override
    public Optional<Preview> byTiles() {
        if (!isByTable() || !hasCoarsest()) {
            return Optional.empty();
        }
        return Optional.of(byTable(1, true));
    }

    private Preview byTable(double divisor, boolean isStill) {
        if (hasCoarsest()) {
            meter(() -> false);
        }
        double exposure = exposureSoFar();
        SceneSession part = current.parts.get(0);
        BufferedImage image = isStill
                ? part.still(state.width(), state.height(), exposure)
                : part.moving(state.width(), state.height(), divisor, exposure);
        return new Preview(image, divisor, hasCoarsest(), exposure, 0, OptionalInt.empty());
    }

    /** Meters the scene unless its exposure is known; returns false if interrupted. */
    private boolean meter(BooleanSupplier interrupted) {
        if (exposures.known(scene(), state.metering()).isEmpty()) {
            current.sum()
                    .exposure(scene(), state.width(), state.height(), current.tiles, interrupted)
                    .ifPresent(exposure -> exposures.store(scene(), state.metering(), exposure));
        }
        return exposures.known(scene(), state.metering()).isPresent();
    }

    private double exposureSoFar() {
        return exposures.soFar(scene(), state.metering());
    }

    @Override
    public Optional<Preview> finer(BooleanSupplier interrupted) {
        if (isByTable()) {
            return underMoreLights(interrupted);
        }
        if (!meter(interrupted) || stride / 2 < FINEST_STRIDE) {
            return Optional.empty();
        }
        stride /= 2;
        return coarse(interrupted);
    }

    /** Draws one sample a pixel under more lights of an environment than before; empty if only the final picture has more, or if interrupted. */
    private Optional<Preview> underMoreLights(BooleanSupplier interrupted) {
        OptionalInt all = meter(interrupted) ? lights(counted(interrupted)) : OptionalInt.empty();
        lights *= MORE_LIGHTS;
        if (all.isEmpty() || lights >= all.getAsInt()) {
            return Optional.empty();
        }
        Scene few = scene().with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights));
        return whole(few, PixelSamples.uniform(1), interrupted, (tile, part, share) -> {})
                .map(image -> new Preview(image, 1, true, exposureSoFar(), 0, OptionalInt.of(lights)));
    }

    /** Returns the scene with its number of lights, which is counted once for all its views. */
    private Scene counted(BooleanSupplier interrupted) {
        if (countedFor == null
                || !SceneSharing.sharesParts(countedFor, scene())
                || !countedFor.exposureInputs().equals(scene().exposureInputs())) {
            count = LightCount.of(current.sum(), scene(), state.width(), state.height(), interrupted);
            countedFor = interrupted.getAsBoolean() ? null : scene();
        }
        return count.map(found -> found.in(scene())).orElse(scene());
    }

    /** Draws the body in full resolution and the diffracted light from one sample per {@link #stride} columns and rows. */
    private Optional<Preview> coarse(BooleanSupplier interrupted) {
        double white = 1 / exposureSoFar();
        Scene few = scene().hasEnvironment()
                ? scene().with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights))
                : scene();
        return current.sum()
                .coarse(few, state.width(), state.height(), stride, white, current.tiles, interrupted)
                .map(picture -> {
                    boolean hasColors = coarsestShare() == 1;
                    if (hasColors) {
                        exposures.storeFirst(
                                scene(),
                                state.metering(),
                                () -> picture.reduced(1).linear());
                    }
                    double exposure = exposureSoFar();
                    double side = samples().side();
                    double seconds = side * side * state.width() * state.height() * current.tiles.secondsPerPixel();
                    BufferedImage image = PixelPicture.image(picture, scene().display(exposure), scene().background());
                    return new Preview(image, stride, hasColors, exposure, seconds, lights(few));
                });
    }

    @Override
    public Optional<Final> refine(BooleanSupplier interrupted, PartListener drawn) {
        if (!meter(interrupted)) {
            return Optional.empty();
        }
        Scene counted = counted(interrupted);
        return whole(counted, samples(), interrupted, drawn)
                .map(image -> new Final(image, exposureSoFar(), lights(counted)));
    }

    /** Draws all tiles; empty if interrupted. */
    private Optional<BufferedImage> whole(
            Scene scene, PixelSamples samples, BooleanSupplier interrupted, PartListener drawn) {
        int width = state.width();
        int height = state.height();
        double exposure = exposureSoFar();
        BufferedImage whole = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        AtomicLong done = new AtomicLong();
        boolean isWhole = current.tiles.draw(SceneSession.tiles(width, height, samples.side()), interrupted, tile -> {
            BufferedImage part = current.sum()
                    .draw(scene, width, height, tile, samples, exposure)
                    .image();
            whole.getRaster().setDataElements(tile.x(), tile.y(), part.getRaster());
            drawn.drawn(tile, part, (double) done.addAndGet(tile.pixels()) / ((double) width * height));
        });
        return isWhole ? Optional.of(whole) : Optional.empty();
    }

    private static OptionalInt lights(Scene scene) {
        return scene.hasEnvironment() ? scene.get(SceneSettings.ENVIRONMENT_LIGHTS) : OptionalInt.empty();
    }

    private Scene scene() {
        return state.firstPart().scene();
    }

    private PixelSamples samples() {
        return PixelSamples.inWindow(scene().method(), state.width(), state.height());
    }

    @Override
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return current.sum().pick(x, y, width, height);
    }

    @Override
    public BufferedImage strokes(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        current.parts.stream()
                .findFirst()
                .ifPresent(session -> LineDrawings.strokes(image.createGraphics(), session, width, height));
        return image;
    }

    @Override
    public void map(
            MapRequest request,
            boolean isFinal,
            BooleanSupplier interrupted,
            BiConsumer<BufferedImage, Boolean> drawn) {
        map.cancel();
        List<SceneSession> parts = own.parts.stream()
                .filter(part -> part.data().draws(request.object(), request.region())
                        && SceneSharing.isSame(part.data().patch(), request.patch()))
                .toList();
        if (parts.isEmpty()) {
            return;
        }
        if (own.colors().findAny().isEmpty()) {
            // A map without color tables takes as long as a picture.
            if (!isMoving) {
                map.draw(parts.get(0).method(), request.light(), isFinal, interrupted, drawn);
            }
        } else if (isFinal) {
            map.drawLater(parts, request.light(), drawn);
        } else if (own.colors().allMatch(VirtualTexture::hasCoarsest)) {
            map.drawMoving(parts, request.light(), drawn);
        }
    }

    @Override
    public void close() {
        try {
            map.cancel();
            own.close();
            other.close();
            baking.finish();
            baking.awaitEnd(PATIENCE_MILLISECONDS);
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        } finally {
            context.close();
        }
    }
}
