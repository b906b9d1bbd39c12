package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import sunbeam.app.failure.Failure;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Scene;

/**
 * Render thread: shows the newest state at once, then, when nothing moves, refines the picture to that of {@code render}
 * (docs/architecture.md). Each turn does one piece of work; a newer state interrupts it after the current part of a picture.
 */
public final class RenderLoop implements AutoCloseable {
    /** Time without a new state after which the scene counts as still; longer than pauses within a drag. */
    static final long STILL_NANOSECONDS = 150_000_000;

    /** Listener of the render thread. Images passed to it do not change afterwards. */
    public interface Listener {
        void opened(String renderer);

        /** Drawing has ended for good, for the reason given in one line. */
        void failed(String message);

        /** A state could not be drawn; the picture on screen stays, and drawing continues. */
        void refused(String message);

        /** A task has failed, such as a pick or the BRDF map; the picture goes on. */
        void problem(String message);

        void body(BufferedImage image);

        void preview(ViewState state, Stage.Preview preview);

        void complete(Finished finished);

        /** Reports the resident share of the final picture's tiles, 0 to 1. */
        void waiting(double share);

        void tile(ViewState state, BufferedImage image, int x, int y, double shareDone);
    }

    enum Phase {
        EMPTY,
        /** Drawing previews while something moves, or until the coarsest tiles are resident. */
        MOVING,
        /** Drawing previews from the resident tiles. */
        WAITING_FOR_TILES,
        REFINING,
        COMPLETE
    }

    // Newest state that is not begun, or null: a newer one replaces an older one.
    private final AtomicReference<ViewState> newest = new AtomicReference<>();
    private final Queue<Consumer<Stage>> tasks = new ConcurrentLinkedQueue<>();
    private volatile boolean isClosed;
    // Has a permit if a state, task, tile or the end may have come since the last turn.
    private final Semaphore events = new Semaphore(0);
    private final Supplier<? extends Stage> opening;
    private final Consumer<Consumer<Listener>> news;
    private final LongSupplier clock;
    private final Thread thread;
    Phase phase = Phase.EMPTY;
    private ViewState state;
    private long previewEnd;
    // Last final picture of the scene's own method (false) and of the comparison method (true).
    private final Map<Boolean, Finished> finished = new HashMap<>();

    /** Final picture of a state, and the time since all its tiles were resident. */
    public record Finished(ViewState state, Stage.Final picture, long nanoseconds) {}

    /**
     * Creates a loop whose thread, once started, creates the stage by {@code opening}; {@code news} passes notifications to the listener, perhaps
     * on another thread; {@code clock} is in nanoseconds.
     */
    public RenderLoop(Supplier<? extends Stage> opening, Consumer<Consumer<Listener>> news, LongSupplier clock) {
        this.opening = opening;
        this.news = news;
        this.clock = clock;
        this.thread = new Thread(this::run, "render");
        thread.setDaemon(true);
    }

    public void start() {
        thread.start();
    }

    public void show(ViewState next) {
        newest.set(next);
        events.release();
    }

    /** Shows the body of the first scene, once its shape is loaded, unless a state comes before it. */
    public void showBody(Scene scene, Supplier<SceneShape> shape, int width, int height) {
        submit(stage -> {
            SceneShape loaded = shape.get();
            if (!isInterrupted()) {
                BufferedImage image = stage.body(scene, loaded, width, height);
                news.accept(to -> to.body(image));
            }
        });
    }

    /** Queues a small task, which runs after the current part of a picture. */
    public void submit(Consumer<Stage> task) {
        tasks.add(task);
        events.release();
    }

    /** Requests the end; does not wait for it. */
    @Override
    public void close() {
        isClosed = true;
        events.release();
    }

    public boolean awaitEnd(long milliseconds) throws InterruptedException {
        thread.join(milliseconds);
        return !thread.isAlive();
    }

    private void run() {
        try (Stage stage = opening.get()) {
            String renderer = stage.renderer();
            news.accept(to -> to.opened(renderer));
            while (!isClosed) {
                if (events.tryAcquire(pause(), TimeUnit.NANOSECONDS)) {
                    events.drainPermits();
                }
                turn(stage);
            }
        } catch (RuntimeException | LinkageError | OutOfMemoryError failure) {
            news.accept(to -> to.failed(Failure.of(failure).message()));
        } catch (InterruptedException failure) {
            news.accept(to -> to.failed("the render thread was interrupted"));
        }
    }

    /** Returns the nanoseconds until the next turn, unless a state or task comes earlier; {@link Long#MAX_VALUE} if no work is left. */
    long pause() {
        return switch (phase) {
            case REFINING -> 0;
            case MOVING -> isStill() ? Long.MAX_VALUE : previewEnd + STILL_NANOSECONDS - clock.getAsLong();
            case EMPTY, WAITING_FOR_TILES, COMPLETE -> Long.MAX_VALUE;
        };
    }

    private boolean isStill() {
        return clock.getAsLong() - previewEnd >= STILL_NANOSECONDS;
    }

    /** Does one turn, in this order: small tasks, finished tiles, the newest state, then the work of the current phase. */
    void turn(Stage stage) {
        doTasks(stage);
        // If this state cannot be drawn (out of memory, invalid scene), report it and wait for the next one.
        try {
            boolean hasMoreTiles = stage.takeTiles();
            Optional.ofNullable(newest.getAndSet(null)).ifPresent(next -> begin(stage, next));
            if (phase == Phase.MOVING && isStill()) {
                settle(stage);
            } else if (phase == Phase.WAITING_FOR_TILES && hasMoreTiles) {
                await(stage);
            } else if (phase == Phase.REFINING) {
                refine(stage);
            }
        } catch (RuntimeException | OutOfMemoryError failure) {
            phase = Phase.EMPTY;
            news.accept(to -> to.refused(Failure.of(failure).message()));
        }
    }

    private void doTasks(Stage stage) {
        for (Consumer<Stage> task = tasks.poll(); task != null && !isClosed; task = tasks.poll()) {
            try {
                task.accept(stage);
            } catch (RuntimeException | OutOfMemoryError failure) {
                news.accept(to -> to.problem(Failure.of(failure).message()));
            }
        }
    }

    private void begin(Stage stage, ViewState next) {
        Finished last = finished.get(next.isOther());
        // update() throws before anything changes, so a failure leaves the old picture on screen.
        stage.update(next, events::release);
        state = next;
        if (last != null && next.showsThePictureOf(last.state())) {
            stage.interactive(false);
            complete(stage, last.picture(), last.nanoseconds());
        } else {
            phase = Phase.MOVING;
            stage.interactive(true);
            // A newer state interrupts the comparison's preview, but not the preview of the scene's own method.
            show(stage.moving(next.isOther() ? interruptedBetweenTasks(stage) : () -> isClosed));
            previewEnd = clock.getAsLong();
        }
    }

    private void show(Optional<Stage.Preview> preview) {
        ViewState shown = state;
        preview.ifPresent(picture -> news.accept(to -> to.preview(shown, picture)));
    }

    /** Requests the final picture's tiles when nothing has moved for a while and the coarsest tiles are resident. */
    private void settle(Stage stage) {
        stage.interactive(false);
        if (stage.coarsestShare() < 1) {
            // The picture has no diffracted light before the coarsest level is complete, so the share is 0.
            news.accept(to -> to.waiting(0));
            return;
        }
        // Finding the tiles of all pixels takes seconds: show the coarsest ones first.
        show(stage.byTiles());
        if (stage.request(this::isInterrupted)) {
            phase = Phase.WAITING_FOR_TILES;
            await(stage);
        }
    }

    private void await(Stage stage) {
        double share = stage.requestedShare();
        if (share < 1) {
            show(stage.byTiles());
            news.accept(to -> to.waiting(share));
        } else {
            phase = Phase.REFINING;
        }
    }

    private void refine(Stage stage) {
        ViewState begun = state;
        BooleanSupplier interrupted = interruptedBetweenTasks(stage);
        for (var finer = stage.finer(interrupted); finer.isPresent(); finer = stage.finer(interrupted)) {
            show(finer);
        }
        if (isInterrupted()) {
            return;
        }
        long start = clock.getAsLong();
        stage.refine(
                        interrupted,
                        (tile, part, share) -> news.accept(to -> to.tile(begun, part, tile.x(), tile.y(), share)))
                .ifPresent(picture -> complete(stage, picture, clock.getAsLong() - start));
    }

    private BooleanSupplier interruptedBetweenTasks(Stage stage) {
        return () -> {
            doTasks(stage);
            return isInterrupted();
        };
    }

    private boolean isInterrupted() {
        return isClosed || newest.get() != null;
    }

    /** True if a newer state of the scene's own method waits, or the end. */
    public boolean isOutdated() {
        ViewState next = newest.get();
        return isClosed || (next != null && !next.isOther());
    }

    private void complete(Stage stage, Stage.Final picture, long nanoseconds) {
        phase = Phase.COMPLETE;
        Finished whole = new Finished(state, picture, nanoseconds);
        finished.put(state.isOther(), whole);
        news.accept(to -> to.complete(whole));
        stage.prefetch();
    }
}
