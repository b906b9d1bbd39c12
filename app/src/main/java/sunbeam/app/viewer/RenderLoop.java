package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import jrtr.ContextInfo;
import jrtr.Tile;
import sunbeam.app.commands.failure.Failure;
import sunbeam.app.scene.ScenePreview;
import sunbeam.precompute.method.MethodPlan;

/**
 * The render thread: shows the newest state at once in a preview that keeps to its time, and once nothing moves, refines
 * it tile by tile to what {@code render} draws. A newer state interrupts it after the tile at hand.
 */
final class RenderLoop implements AutoCloseable {
    // Pauses between two events of one drag are shorter.
    private static final long STILL_MILLISECONDS = 150;
    // Of some hundred pages.
    private static final long KEPT_MILLISECONDS = 300;
    private static final long LOOK_MILLISECONDS = 10;

    private final Inbox<ViewState, Consumer<GraphicsStage>> inbox = new Inbox<>();
    private final Supplier<GraphicsStage> opening;
    private final RenderListener listener;
    private final Executor listening;
    private final Thread thread;
    private PreviewScale scale = PreviewScale.first();
    private final MovingScale movingScale = new MovingScale();
    private TileSide tileSide = TileSide.first();
    private MethodPlan measured;
    private final KeptExposure exposures = new KeptExposure();
    private Optional<Finished> finished = Optional.empty();
    // Waits for colors that are being made.
    private Optional<ViewState> unfinished = Optional.empty();
    // Whether it is known where its pixels look.
    private boolean isRequested;

    /** A final picture: as long as nothing but the map changes, it stays. */
    private record Finished(ViewState state, BufferedImage image, double exposure, long nanoseconds) {}

    /**
     * @param opening makes the stage, on the render thread
     * @param listening runs what the listener is told
     */
    RenderLoop(Supplier<GraphicsStage> opening, RenderListener listener, Executor listening) {
        this.opening = opening;
        this.listener = listener;
        this.listening = listening;
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
            tell(to -> to.opened(info));
            while (!inbox.isClosed()) {
                inbox.await();
                doTasks(stage);
                inbox.state().ifPresent(state -> guarded(() -> show(stage, state)));
            }
        } catch (RuntimeException | LinkageError | OutOfMemoryError failure) {
            tell(to -> to.failed(Failure.of(failure).message()));
        } catch (InterruptedException failure) {
            tell(to -> to.failed("the render thread was interrupted"));
        }
    }

    /** Colors have come that a picture which stands still may have waited for. */
    private void goOn(GraphicsStage stage) {
        if (stage.takeBaked() && unfinished.isPresent() && !inbox.isInterrupted()) {
            ViewState state = unfinished.get();
            double share = stage.requestedShare();
            guarded(() -> {
                if (share < 1) {
                    await(stage, state, share);
                } else if (isRequested) {
                    refineWhole(stage, state);
                } else {
                    finish(stage, state);
                }
            });
        }
    }

    private void tell(Consumer<RenderListener> news) {
        listening.execute(() -> news.accept(listener));
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
            tell(to -> to.refused(Failure.of(failure).message()));
        }
    }

    private void show(GraphicsStage stage, ViewState state) {
        stage.update(state);
        stage.bakeInBackground(() -> inbox.submit(this::goOn));
        Optional<Finished> kept = finished.filter(picture -> picture.state().showsThePictureOf(state));
        if (kept.isPresent()) {
            Finished picture = kept.get();
            tell(to -> to.complete(state, picture.image(), picture.exposure(), picture.nanoseconds()));
            check(map(stage, state, false) && map(stage, state, true));
            guarded(() -> stage.requestMoving(state.width(), state.height(), inbox::isInterrupted));
            return;
        }
        finished = Optional.empty();
        unfinished = Optional.empty();
        if (state.isBare() && stage.canMoveSoon()) {
            awaitKept(stage);
        }
        preview(stage, state);
        if (isStill(stage)) {
            finish(stage, state);
        }
    }

    /** Colors that an earlier run has kept are read sooner than the body alone is drawn. */
    private void awaitKept(GraphicsStage stage) {
        long end = System.nanoTime() + KEPT_MILLISECONDS * 1_000_000;
        try {
            while (!stage.canMove() && System.nanoTime() < end && !inbox.isInterrupted()) {
                Thread.sleep(LOOK_MILLISECONDS);
                stage.takeBaked();
            }
        } catch (InterruptedException failure) {
            Thread.currentThread().interrupt();
        }
    }

    /** Refines what stands still, as far as its colors have been made; the rest is taken up when they come. */
    private void finish(GraphicsStage stage, ViewState state) {
        if (state.isBare()) {
            // Before it is found where all pixels look, which takes seconds.
            unfinished = Optional.of(state);
            isRequested = false;
            await(stage, state, 0);
            if (!stage.canMove()) {
                return;
            }
        }
        OptionalDouble found = stage.request(state.width(), state.height(), inbox::isInterrupted);
        if (found.isEmpty()) {
            return;
        }
        double share = found.getAsDouble();
        if (share < 1) {
            unfinished = Optional.of(state);
            isRequested = true;
            await(stage, state, share);
            map(stage, state, false);
            stage.prepareDrawing(state.width(), state.height());
            return;
        }
        refineWhole(stage, state);
    }

    /** Refines what all colors are there for. */
    private void refineWhole(GraphicsStage stage, ViewState state) {
        unfinished = Optional.empty();
        check(map(stage, state, false) && refine(stage, state));
        guarded(() -> stage.requestMoving(state.width(), state.height(), inbox::isInterrupted));
    }

    /** Shows what there is while colors are being made. */
    private void await(GraphicsStage stage, ViewState state, double share) {
        if (stage.canMove()) {
            moving(stage, state, 1, exposures.of(state.fine(), stage::previewExposure));
        }
        tell(to -> to.waiting(share));
    }

    private void check(boolean done) {
        if (!done && !inbox.isInterrupted()) {
            throw new IllegalStateException("refinement ended early without a newer state");
        }
    }

    private boolean isStill(GraphicsStage stage) {
        try {
            long end = System.nanoTime() + STILL_MILLISECONDS * 1_000_000;
            while (inbox.staysStill(Math.max(0, (end - System.nanoTime()) / 1_000_000))) {
                doTasks(stage);
                if (System.nanoTime() >= end) {
                    return true;
                }
            }
            return false;
        } catch (InterruptedException failure) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** Shows what moves, as large as there is time for: by tables where colors for that are there, else by the preview's plan. */
    private void preview(GraphicsStage stage, ViewState state) {
        OptionalDouble known = exposures.known(state.fine());
        if (known.isPresent() && state.isBare() && !stage.canMove()) {
            // The body alone, by what will draw its colors.
            moving(stage, state, 1, known.getAsDouble());
        } else if (stage.canMove()) {
            double exposure = exposures.of(state.fine(), stage::previewExposure);
            stage.holdBaking();
            long start = System.nanoTime();
            moving(stage, state, movingScale.divisor(), exposure);
            movingScale.frame(System.nanoTime() - start);
        } else {
            // Baking goes on meanwhile: whoever keeps moving would never come to see more.
            reduced(stage, state);
        }
    }

    private void moving(GraphicsStage stage, ViewState state, int divisor, double exposure) {
        long start = System.nanoTime();
        boolean colors = stage.canMove();
        BufferedImage image = stage.moving(state.width(), state.height(), divisor, exposure);
        long taken = System.nanoTime() - start;
        tell(to -> to.preview(state, image, divisor, colors, exposure, taken));
    }

    private void reduced(GraphicsStage stage, ViewState state) {
        long start = System.nanoTime();
        // The body alone takes no time.
        int divisor = state.isBare() ? 1 : scale.divisor();
        ScenePreview preview = stage.preview(state.width(), state.height(), divisor);
        double exposure = state.isBare() ? bodyExposure(state) : exposures.of(state.fine(), stage::previewExposure);
        BufferedImage image = stage.image(preview.picture(), exposure);
        long taken = System.nanoTime() - start;
        followTime(state.coarse().method(), taken, preview.fixed(taken));
        tell(to -> to.preview(state, image, divisor, false, exposure, taken));
    }

    /** Nothing is metered while diffracted light is missing: until then, a white body that faces the light is white. */
    private double bodyExposure(ViewState state) {
        double intensity = state.fine().scene().light().intensity();
        return exposures.known(state.fine()).orElse(intensity > 0 ? 1 / intensity : 1);
    }

    /** A method's first frame is left out: the driver compiles its shaders then. */
    @SuppressWarnings("ReferenceEquality") // the same object as long as nothing is loaded anew
    private void followTime(MethodPlan method, long nanoseconds, long fixed) {
        if (method == measured) {
            scale = scale.after(nanoseconds, fixed);
        } else {
            scale = PreviewScale.first();
        }
        measured = method;
    }

    /**
     * Draws the final picture and its map; false if it was interrupted. A newer state that shows the same picture goes on
     * with what is drawn already.
     */
    private boolean refine(GraphicsStage stage, ViewState first) {
        ViewState state = first;
        long start = System.nanoTime();
        double exposure = exposures.found(state.fine(), stage.exposure());
        BufferedImage whole = new BufferedImage(state.width(), state.height(), BufferedImage.TYPE_INT_RGB);
        long done = 0;
        for (Tile block : stage.tiles(state.width(), state.height())) {
            for (Tile tile : block.divided(tileSide.side())) {
                doTasks(stage);
                Optional<ViewState> picked = inbox.stateIf(first::showsThePictureOf);
                if (picked.isPresent()) {
                    state = picked.get();
                    map(stage, state, false);
                }
                if (inbox.isInterrupted()) {
                    return false;
                }
                if (state.isBare()) {
                    // All of its colors are there: what the background makes is for other pictures.
                    stage.holdBaking();
                }
                long begun = System.nanoTime() - stage.meshNanoseconds();
                BufferedImage part = stage.part(state.width(), state.height(), tile, exposure);
                long taken = System.nanoTime() - stage.meshNanoseconds() - begun;
                tileSide = tileSide.after(tile.pixels(), taken);
                whole.getRaster().setDataElements(tile.x(), tile.y(), part.getRaster());
                done += tile.pixels();
                double share = (double) done / ((double) state.width() * state.height());
                ViewState shown = state;
                tell(to -> to.tile(shown, part, tile.x(), tile.y(), share));
            }
        }
        long taken = System.nanoTime() - start;
        finished = Optional.of(new Finished(state, whole, exposure, taken));
        ViewState shown = state;
        tell(to -> to.complete(shown, whole, exposure, taken));
        return map(stage, state, true);
    }

    /** Draws the BRDF map, if it is shown; false if it was interrupted. The picture does not wait for one that fails. */
    private boolean map(GraphicsStage stage, ViewState state, boolean isFinal) {
        state.mapLight()
                .ifPresent(light -> guarded(() -> {
                    int size = isFinal ? MapStage.SIZE : MapStage.PREVIEW_SIZE;
                    BufferedImage image = stage.map(light, size, inbox::isInterrupted);
                    if (image != null) {
                        tell(to -> to.map(state, image, isFinal));
                    }
                }));
        return !inbox.isInterrupted();
    }
}
