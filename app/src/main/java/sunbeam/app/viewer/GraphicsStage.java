package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import jrtr.ContextInfo;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.PixelSamples;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.TimedTiles;
import sunbeam.precompute.optics.Direction;

/** Everything of the viewer that lives on the graphics card. */
final class GraphicsStage implements Stage {
    // For what is being evaluated when the window closes.
    private static final long PATIENCE_MILLISECONDS = 5000;
    // For the diffracted light of what moves by a method without tables; its body takes as much.
    private static final long MOVING_NANOSECONDS = 400_000_000;
    // Of the last picture before the final one.
    private static final int FINEST_STRIDE = 4;

    private final RenderContext context;
    private final MapStage map;
    // One thread: sources of colors may belong to it.
    private final ExecutorService baking = Executors.newSingleThreadExecutor(work -> {
        Thread thread = new Thread(work, "colors");
        thread.setDaemon(true);
        return thread;
    });
    private final CachedExposure exposures = new CachedExposure();
    private TimedTiles tiles;
    private FrameScale scale;
    private SceneData scaled;
    // Of the last picture by few samples.
    private int stride;
    private List<SceneSession> parts = List.of();
    private ViewState state;
    private boolean isMoving;

    /** Opens a context without a window. */
    GraphicsStage() {
        context = RenderContext.offscreen();
        map = new MapStage(context);
    }

    @Override
    public ContextInfo info() {
        return context.info();
    }

    @Override
    public void update(ViewState next, Runnable arrived) {
        List<SceneData> wanted = next.scene().parts();
        if (parts.size() == wanted.size()) {
            List<SceneData> before = parts.stream().map(SceneSession::data).toList();
            try {
                update(wanted);
            } catch (RuntimeException | OutOfMemoryError failure) {
                update(before);
                throw failure;
            }
        } else {
            replace(wanted);
        }
        state = next;
        colors().forEach(colors -> colors.makeBy(baking, arrived));
        followCost(next.fine());
    }

    private void update(List<SceneData> data) {
        for (int i = 0; i < parts.size(); i++) {
            parts.get(i).update(data.get(i));
        }
    }

    private void replace(List<SceneData> wanted) {
        List<SceneSession> made = new ArrayList<>();
        try {
            wanted.forEach(data -> made.add(new SceneSession(context, data)));
        } catch (RuntimeException | OutOfMemoryError failure) {
            made.forEach(SceneSession::close);
            throw failure;
        }
        parts.forEach(SceneSession::close);
        parts = List.copyOf(made);
    }

    /** Another method or mesh takes another time. */
    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing is loaded anew
    private void followCost(SceneData data) {
        if (scaled == null || data.method() != scaled.method() || data.mesh() != scaled.mesh()) {
            scale = new FrameScale();
            tiles = new TimedTiles(this::pixelClock);
        }
        scaled = data;
    }

    /** Nanoseconds that go by while pixels are drawn, but not while the mesh is. */
    private long pixelClock() {
        return System.nanoTime()
                - parts.stream().mapToLong(SceneSession::meshNanoseconds).sum();
    }

    private Stream<LevelTiles> colors() {
        return parts.stream().flatMap(part -> part.tiles().stream());
    }

    @Override
    public void interactive(boolean value) {
        isMoving = value;
        colors().forEach(colors -> colors.interactive(value));
        if (value) {
            map.cancel();
        }
    }

    @Override
    public boolean takeTiles() {
        return colors().map(LevelTiles::take).reduce(false, Boolean::logicalOr);
    }

    @Override
    public boolean request(BooleanSupplier interrupted) {
        for (SceneSession part : parts) {
            if (!part.request(state.width(), state.height(), samples(), interrupted)) {
                return false;
            }
        }
        return true;
    }

    @Override
    public double requestedShare() {
        return average(LevelTiles::requestedShare);
    }

    @Override
    public double coarsestShare() {
        return average(LevelTiles::coarsestShare);
    }

    private double average(ToDoubleFunction<LevelTiles> share) {
        return colors().mapToDouble(share).average().orElse(1);
    }

    @Override
    public void prefetch() {
        colors().forEach(LevelTiles::validate);
        colors().forEach(LevelTiles::prefetch);
    }

    /** Whether what moves is drawn by color tables; the sum of several is not. */
    private boolean isByTable() {
        return parts.size() == 1 && colors().findAny().isPresent();
    }

    /** Whether all pixels have colors, if only those of the coarsest mip level. */
    private boolean hasCoarsest() {
        return colors().allMatch(LevelTiles::hasCoarsest);
    }

    @Override
    public Optional<Preview> moving(BooleanSupplier interrupted) {
        if (isByTable()) {
            long start = pixelClock();
            Preview preview = byTable(scale.divisor());
            scale.frame(pixelClock() - start);
            return Optional.of(preview);
        }
        stride = tiles.stride(state.width(), state.height(), MOVING_NANOSECONDS);
        long start = System.nanoTime();
        // What takes much longer than it was thought to is begun again with fewer samples.
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
        return isByTable() && hasCoarsest() ? Optional.of(byTable(1)) : Optional.empty();
    }

    private Preview byTable(int divisor) {
        double exposure = exposureSoFar();
        BufferedImage image = parts.get(0).moving(state.width(), state.height(), divisor, exposure);
        return new Preview(image, divisor, hasCoarsest(), exposure);
    }

    /** Tables are metered once all their tiles are there: until then, a white body that faces the light is white. */
    private double exposureSoFar() {
        double intensity = scene().light().intensity();
        return exposures.known(state.fine()).orElse(intensity > 0 ? 1 / intensity : 1);
    }

    @Override
    public Optional<Preview> finer(BooleanSupplier interrupted) {
        if (isByTable() || stride / 2 < FINEST_STRIDE) {
            return Optional.empty();
        }
        stride /= 2;
        return coarse(interrupted);
    }

    /** By few samples of diffracted light over the whole body. */
    private Optional<Preview> coarse(BooleanSupplier interrupted) {
        double white = 1 / exposureSoFar();
        return sum().coarse(scene(), state.width(), state.height(), stride, white, tiles, interrupted)
                .map(picture -> {
                    double exposure = exposures.of(state.fine(), () -> AutoExposure.of(picture.linear()));
                    return new Preview(image(picture, 1, exposure), stride, true, exposure);
                });
    }

    @Override
    public Optional<Final> refine(BooleanSupplier interrupted, PartListener drawn) {
        int width = state.width();
        int height = state.height();
        int samples = samples();
        OptionalDouble metered = SceneDisplay.exposure(scene(), sum(), width, height, tiles, interrupted);
        if (metered.isEmpty()) {
            return Optional.empty();
        }
        double exposure = exposures.found(state.fine(), metered.getAsDouble());
        BufferedImage whole = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        AtomicLong done = new AtomicLong();
        boolean isWhole = tiles.draw(SceneSession.tiles(width, height, samples), interrupted, tile -> {
            BufferedImage part = image(sum().samples(scene(), width, height, tile, samples), samples, exposure);
            whole.getRaster().setDataElements(tile.x(), tile.y(), part.getRaster());
            drawn.drawn(tile, part, (double) done.addAndGet(tile.pixels()) / ((double) width * height));
        });
        return isWhole ? Optional.of(new Final(whole, exposure)) : Optional.empty();
    }

    private PartSum sum() {
        return new PartSum(parts);
    }

    /** As a screen shows it, from so many samples along a pixel's side. */
    private BufferedImage image(ScenePicture picture, int samples, double exposure) {
        return SceneDisplay.image(picture, samples, scene().display(exposure), scene().background());
    }

    private Scene scene() {
        return state.fine().scene();
    }

    /** As many as {@code render} takes. */
    private int samples() {
        return PixelSamples.alongSide(scene().method(), state.width(), state.height());
    }

    @Override
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return parts.isEmpty() ? Optional.empty() : parts.get(0).pick(x, y, width, height);
    }

    @Override
    public void map(
            ViewState shown, boolean isFinal, BooleanSupplier interrupted, BiConsumer<BufferedImage, Boolean> drawn) {
        map.cancel();
        if (shown.mapLight().isEmpty()) {
            return;
        }
        Direction light = shown.mapLight().get();
        if (colors().findAny().isEmpty()) {
            // It takes as long as a picture does.
            if (!isMoving) {
                map.draw(parts.get(0).method(), light, isFinal, interrupted, drawn);
            }
        } else if (isFinal) {
            map.drawLater(parts, light, drawn);
        } else if (isMoving && hasCoarsest()) {
            map.drawCoarse(parts, light, drawn);
        }
    }

    @Override
    public void close() {
        try {
            map.cancel();
            parts.forEach(SceneSession::close);
            baking.shutdown();
            baking.awaitTermination(PATIENCE_MILLISECONDS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        } finally {
            context.close();
        }
    }
}
