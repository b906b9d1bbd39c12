package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import jrtr.ContextInfo;
import sunbeam.app.commands.failure.Failure;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.ScenePicture;

/**
 * The render thread: shows the newest state at once in a preview that keeps to its time, and once nothing moves, refines
 * it tile by tile to what {@code render} draws. A newer state interrupts it after the tile at hand.
 */
final class RenderLoop implements AutoCloseable {
    // Pauses between two events of one drag are shorter.
    private static final long STILL_NANOSECONDS = 150_000_000;
    // For the diffracted light of what moves by a method without tables; its body takes as much.
    private static final long MOVING_NANOSECONDS = 400_000_000;
    // Of the last picture before the final one.
    private static final int FINEST_STRIDE = 4;

    private final Inbox<ViewState, Consumer<GraphicsStage>> inbox = new Inbox<>();
    private final Supplier<GraphicsStage> opening;
    private final Consumer<Consumer<RenderListener>> news;
    private final Thread thread;
    private FrameScale scale = new FrameScale();
    private SceneData scaled;
    private final CachedExposure exposures = new CachedExposure();
    private Optional<Finished> finished = Optional.empty();
    // Waits for tiles that are being baked.
    private Optional<ViewState> unfinished = Optional.empty();
    // Whether the tiles that it looks into are known.
    private boolean isRequested;
    // What is on screen, or will be.
    private ViewState shown;

    /** A final picture: as long as nothing but the map changes, it stays. */
    private record Finished(ViewState state, BufferedImage image, double exposure, long nanoseconds) {}

    /**
     * @param opening makes the stage, on the render thread
     * @param news has the listener hear what it is handed, perhaps on another thread
     */
    RenderLoop(Supplier<GraphicsStage> opening, Consumer<Consumer<RenderListener>> news) {
        this.opening = opening;
        this.news = news;
        this.thread = new Thread(this::run, "render");
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** Shows this from now on. */
    void show(ViewState state) {
        inbox.show(state);
    }

    /** Does something small on the render thread, at the next tile. */
    void submit(Consumer<GraphicsStage> task) {
        inbox.submit(task);
    }

    /** Ends after the tile at hand; does not wait for it. */
    @Override
    public void close() {
        inbox.close();
    }

    /** Waits until the graphics card is given back. */
    boolean awaitEnd(long milliseconds) throws InterruptedException {
        thread.join(milliseconds);
        return !thread.isAlive();
    }

    private void run() {
        try (GraphicsStage stage = opening.get()) {
            ContextInfo info = stage.info();
            report(to -> to.opened(info));
            while (!inbox.isClosed()) {
                inbox.await();
                doTasks(stage);
                inbox.state().ifPresent(state -> guarded(() -> show(stage, state)));
            }
        } catch (RuntimeException | LinkageError | OutOfMemoryError failure) {
            report(to -> to.failed(Failure.of(failure).message()));
        } catch (InterruptedException failure) {
            report(to -> to.failed("the render thread was interrupted"));
        }
    }

    private void report(Consumer<RenderListener> what) {
        news.accept(what);
    }

    private void doTasks(GraphicsStage stage) {
        for (var task = inbox.task(); task.isPresent(); task = inbox.task()) {
            Consumer<GraphicsStage> due = task.get();
            guarded(() -> due.accept(stage));
        }
    }

    /** What has no room on the card or in the heap, or cannot be drawn, is given up; what is asked for next may do. */
    private void guarded(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException | OutOfMemoryError failure) {
            report(to -> to.refused(Failure.of(failure).message()));
        }
    }

    private void show(GraphicsStage stage, ViewState state) {
        stage.update(state);
        shown = state;
        stage.bakeInBackground(() -> inbox.submit(this::takeBaked));
        Optional<Finished> same = finished.filter(picture -> picture.state().showsThePictureOf(state));
        if (same.isPresent()) {
            Finished picture = same.get();
            report(to -> to.complete(state, picture.image(), picture.exposure(), picture.nanoseconds()));
            maps(stage, state);
            return;
        }
        finished = Optional.empty();
        unfinished = Optional.empty();
        move(stage, state);
        if (isStill(stage)) {
            finish(stage, state);
        }
    }

    /** Shows what moves, in as many pixels as there is time for, or by as many samples. */
    private void move(GraphicsStage stage, ViewState state) {
        if (stage.hasColors()) {
            // Else baking goes on: whoever keeps moving would never come to see more.
            stage.holdBaking();
        }
        if (stage.isByTable()) {
            followScale(state.fine());
            long start = stage.pixelClock();
            byTable(stage, state, scale.divisor());
            scale.frame(stage.pixelClock() - start);
        } else {
            coarse(stage, state, stage.stride(MOVING_NANOSECONDS), inbox::isClosed);
        }
    }

    /** Another method or mesh takes another time. */
    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing is loaded anew
    private void followScale(SceneData data) {
        if (scaled == null || data.method() != scaled.method() || data.mesh() != scaled.mesh()) {
            scale = new FrameScale();
        }
        scaled = data;
    }

    /** Shows a whole picture by the tiles of color tables that there are. */
    private void byTable(GraphicsStage stage, ViewState state, int divisor) {
        SceneData data = state.fine();
        boolean hasColors = stage.hasColors();
        double exposure = exposureSoFar(data);
        BufferedImage image = stage.byTable(divisor, exposure);
        report(to -> to.preview(state, image, divisor, hasColors, exposure));
    }

    /** Shows a whole picture by few samples of its diffracted light; whether it was not interrupted. */
    private boolean coarse(GraphicsStage stage, ViewState state, int stride, BooleanSupplier interrupted) {
        SceneData data = state.fine();
        Optional<ScenePicture> coarse = stage.coarse(stride, 1 / exposureSoFar(data), interrupted);
        coarse.ifPresent(picture -> {
            double exposure = exposures.of(data, () -> AutoExposure.of(picture.linear()));
            BufferedImage image = stage.image(picture, 1, exposure);
            report(to -> to.preview(state, image, stride, true, exposure));
        });
        return coarse.isPresent();
    }

    /** Tables are metered once all their tiles are there: until then, a white body that faces the light is white. */
    private double exposureSoFar(SceneData data) {
        double intensity = data.scene().light().intensity();
        return exposures.known(data).orElse(intensity > 0 ? 1 / intensity : 1);
    }

    /** Refines what stands still, as far as its tiles are baked; the rest is taken up when they come. */
    private void finish(GraphicsStage stage, ViewState state) {
        unfinished = Optional.of(state);
        isRequested = false;
        double coarsest = stage.coarsestShare();
        if (coarsest < 1) {
            await(stage, state, coarsest);
            return;
        }
        if (stage.isByTable()) {
            // It takes seconds to find which tiles all pixels look into.
            byTable(stage, state, 1);
        }
        OptionalDouble share = stage.request(inbox::isInterrupted);
        isRequested = share.isPresent();
        if (isRequested && share.getAsDouble() < 1) {
            await(stage, state, share.getAsDouble());
        } else if (isRequested) {
            refineWhole(stage, state);
        }
    }

    /** Tiles have come that a picture which stands still may wait for. */
    private void takeBaked(GraphicsStage stage) {
        if (stage.takeBaked() && unfinished.isPresent() && !inbox.isInterrupted()) {
            ViewState state = unfinished.get();
            guarded(() -> {
                if (!isRequested) {
                    finish(stage, state);
                } else if (stage.requestedShare() < 1) {
                    await(stage, state, stage.requestedShare());
                } else {
                    refineWhole(stage, state);
                }
            });
        }
    }

    /** Shows what there is while tiles are being baked. */
    private void await(GraphicsStage stage, ViewState state, double share) {
        if (stage.isByTable() && stage.hasColors()) {
            byTable(stage, state, 1);
        }
        report(to -> to.waiting(share));
    }

    /** Refines what all tiles are there for. */
    private void refineWhole(GraphicsStage stage, ViewState state) {
        unfinished = Optional.empty();
        // That of a table takes seconds, which the picture does not wait for.
        if (stage.isByTable() || map(stage, state, false)) {
            refine(stage, state);
        }
    }

    /** Waits a while for a newer state; whether none has come. */
    private boolean isStill(GraphicsStage stage) {
        long end = System.nanoTime() + STILL_NANOSECONDS;
        try {
            while (System.nanoTime() < end - 1_000_000 && !inbox.isInterrupted()) {
                inbox.awaitUntil(end);
                doTasks(stage);
            }
        } catch (InterruptedException failure) {
            Thread.currentThread().interrupt();
            return false;
        }
        return !inbox.isInterrupted();
    }

    /** Draws finer and finer pictures, the final one and its map, unless it is interrupted. */
    private void refine(GraphicsStage stage, ViewState state) {
        BooleanSupplier interrupted = () -> isOvertaken(stage, state);
        if (!stage.isByTable()) {
            for (int stride = stage.stride(MOVING_NANOSECONDS) / 2; stride >= FINEST_STRIDE; stride /= 2) {
                if (!coarse(stage, shown, stride, interrupted)) {
                    return;
                }
            }
        }
        long start = System.nanoTime();
        OptionalDouble metered = stage.exposure(interrupted);
        if (metered.isEmpty()) {
            return;
        }
        double exposure = exposures.found(state.fine(), metered.getAsDouble());
        BufferedImage whole = new BufferedImage(state.width(), state.height(), BufferedImage.TYPE_INT_RGB);
        AtomicLong done = new AtomicLong();
        boolean isWhole = stage.refine(exposure, interrupted, (tile, part) -> {
            whole.getRaster().setDataElements(tile.x(), tile.y(), part.getRaster());
            double share = (double) done.addAndGet(tile.pixels()) / ((double) state.width() * state.height());
            report(to -> to.tile(part, tile.x(), tile.y(), share));
        });
        if (isWhole) {
            Finished picture = new Finished(shown, whole, exposure, System.nanoTime() - start);
            finished = Optional.of(picture);
            report(to -> to.complete(picture.state(), whole, exposure, picture.nanoseconds()));
            maps(stage, picture.state());
        }
    }

    /** Whether a picture is out of date. A newer state that shows the same goes on with what is drawn already. */
    private boolean isOvertaken(GraphicsStage stage, ViewState state) {
        doTasks(stage);
        inbox.stateIf(state::showsThePictureOf).ifPresent(same -> {
            shown = same;
            if (!stage.isByTable()) {
                map(stage, same, false);
            }
        });
        if (stage.isByTable()) {
            // All of its tiles are there: what the background bakes is for other pictures.
            stage.holdBaking();
        }
        return inbox.isInterrupted();
    }

    private void maps(GraphicsStage stage, ViewState state) {
        if (map(stage, state, false)) {
            map(stage, state, true);
        }
    }

    /** Draws the BRDF map, if it is shown; false if it was interrupted. The picture does not wait for one that fails. */
    private boolean map(GraphicsStage stage, ViewState state, boolean isFinal) {
        state.mapLight()
                .ifPresent(light -> guarded(() -> {
                    int size = isFinal ? MapStage.SIZE : MapStage.PREVIEW_SIZE;
                    BufferedImage image = stage.map(light, size, inbox::isInterrupted);
                    if (image != null) {
                        report(to -> to.map(state, image, isFinal));
                    }
                }));
        return !inbox.isInterrupted();
    }
}
