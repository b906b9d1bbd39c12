package sunbeam.app.viewer.loop;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import jrtr.ContextInfo;
import sunbeam.app.commands.failure.Failure;

/**
 * The render thread: shows the newest state at once, and once nothing moves, refines it to what {@code render} draws
 * (docs/architecture.md). Each turn does one piece of work; a newer state interrupts it after the part of a picture at hand.
 */
public final class RenderLoop implements AutoCloseable {
    /** Pauses between two events of one drag are shorter. */
    static final long STILL_NANOSECONDS = 150_000_000;

    /** What is on screen, or will be. */
    enum Phase {
        /** Nothing that can be drawn. */
        EMPTY,
        /** Previews of what moves, or of what every pixel waits for colors of. */
        MOVING,
        /** Previews by those tiles that are there. */
        WAITING_FOR_TILES,
        /** Finer and finer pictures. */
        REFINING,
        COMPLETE
    }

    private final Inbox<ViewState, Consumer<Stage>> inbox = new Inbox<>();
    private final Supplier<? extends Stage> opening;
    private final Consumer<Consumer<RenderListener>> news;
    private final LongSupplier clock;
    private final Thread thread;
    private Phase phase = Phase.EMPTY;
    private ViewState state;
    // When it was on screen.
    private long since;
    // The last final pictures: by the scene's own method, and by the other of two.
    private final Map<Boolean, Finished> finished = new HashMap<>();

    private record Finished(ViewState state, Stage.Final picture, long nanoseconds) {}

    /**
     * @param opening makes the stage, on the render thread
     * @param news has the listener hear what it is handed, perhaps on another thread
     */
    public RenderLoop(Supplier<? extends Stage> opening, Consumer<Consumer<RenderListener>> news) {
        this(opening, news, System::nanoTime);
    }

    /** @param clock in nanoseconds */
    RenderLoop(Supplier<? extends Stage> opening, Consumer<Consumer<RenderListener>> news, LongSupplier clock) {
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
        inbox.show(next);
    }

    /** Does something small on the render thread, at the next part of a picture. */
    public void submit(Consumer<Stage> task) {
        inbox.submit(task);
    }

    /** Ends after the part of a picture at hand; does not wait for it. */
    @Override
    public void close() {
        inbox.close();
    }

    /** Waits until the graphics card is given back. */
    public boolean awaitEnd(long milliseconds) throws InterruptedException {
        thread.join(milliseconds);
        return !thread.isAlive();
    }

    private void run() {
        try (Stage stage = opening.get()) {
            ContextInfo info = stage.info();
            news.accept(to -> to.opened(info));
            while (!inbox.isClosed()) {
                inbox.await(pause());
                turn(stage);
            }
        } catch (RuntimeException | LinkageError | OutOfMemoryError failure) {
            news.accept(to -> to.failed(Failure.of(failure).message()));
        } catch (InterruptedException failure) {
            news.accept(to -> to.failed("the render thread was interrupted"));
        }
    }

    Phase phase() {
        return phase;
    }

    /** Nanoseconds until the next turn, unless something comes before; {@link Long#MAX_VALUE} where nothing is left to do. */
    long pause() {
        return switch (phase) {
            case REFINING -> 0;
            case MOVING -> isStill() ? Long.MAX_VALUE : since + STILL_NANOSECONDS - clock.getAsLong();
            case EMPTY, WAITING_FOR_TILES, COMPLETE -> Long.MAX_VALUE;
        };
    }

    private boolean isStill() {
        return clock.getAsLong() - since >= STILL_NANOSECONDS;
    }

    /** The order of work: small tasks, tiles that have come, the newest state, and what brings it nearer to its final picture. */
    void turn(Stage stage) {
        doTasks(stage);
        // What has no room on the card or in the heap, or cannot be drawn, is given up; what is asked for next may do.
        try {
            boolean hasMoreTiles = stage.takeTiles();
            inbox.state().ifPresent(newest -> begin(stage, newest));
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
        for (var task = inbox.task(); task.isPresent(); task = inbox.task()) {
            try {
                task.get().accept(stage);
            } catch (RuntimeException | OutOfMemoryError failure) {
                news.accept(to -> to.refused(Failure.of(failure).message()));
            }
        }
    }

    /** Shows a state at once; one that differs in its BRDF map alone goes on with the picture that is there, or with its final one. */
    private void begin(Stage stage, ViewState next) {
        boolean isSame = phase != Phase.EMPTY && phase != Phase.MOVING && next.showsThePictureOf(state);
        Finished last = finished.get(next.isOther());
        boolean isFinished = last != null && next.showsThePictureOf(last.state());
        // Whoever fails leaves nothing that is shown.
        stage.update(next, () -> inbox.submit(ignored -> {}));
        state = next;
        if (isFinished) {
            phase = Phase.COMPLETE;
            stage.interactive(false);
            complete(stage);
        } else if (!isSame) {
            phase = Phase.MOVING;
            stage.interactive(true);
            // Nobody waits for the other method while the scene's own moves.
            show(stage.moving(next.isOther() ? inbox::isInterrupted : inbox::isClosed));
            map(stage, false);
            since = clock.getAsLong();
        }
    }

    private void show(Optional<Stage.Preview> preview) {
        ViewState shown = state;
        preview.ifPresent(picture -> news.accept(to -> to.preview(shown, picture)));
    }

    /** Nothing has moved for a while: requests what the final picture looks into, as soon as each pixel has some color. */
    private void settle(Stage stage) {
        stage.interactive(false);
        if (stage.coarsestShare() < 1) {
            // The picture has no diffracted light yet, whatever share of the coarsest level was in the cache.
            news.accept(to -> to.waiting(0));
            return;
        }
        // It takes seconds to find which tiles all pixels look into.
        show(stage.byTiles());
        if (stage.request(inbox::isInterrupted)) {
            phase = Phase.WAITING_FOR_TILES;
            await(stage);
        }
    }

    /** Shows what there is while tiles are being made. */
    private void await(Stage stage) {
        double share = stage.requestedShare();
        if (share < 1) {
            show(stage.byTiles());
            news.accept(to -> to.waiting(share));
        } else {
            phase = Phase.REFINING;
            map(stage, false);
        }
    }

    /** Draws finer and finer pictures up to the final one, unless it is interrupted. */
    private void refine(Stage stage) {
        ViewState begun = state;
        BooleanSupplier interrupted = () -> isOvertaken(stage, begun);
        for (var finer = stage.finer(interrupted); finer.isPresent(); finer = stage.finer(interrupted)) {
            show(finer);
        }
        if (inbox.isInterrupted()) {
            return;
        }
        long start = clock.getAsLong();
        stage.refine(
                        interrupted,
                        (tile, part, share) -> news.accept(to -> to.tile(begun, part, tile.x(), tile.y(), share)))
                .ifPresent(picture -> {
                    finished.put(state.isOther(), new Finished(state, picture, clock.getAsLong() - start));
                    phase = Phase.COMPLETE;
                    complete(stage);
                });
    }

    /** Whether a picture is out of date. A newer state that shows the same goes on with what is drawn already. */
    private boolean isOvertaken(Stage stage, ViewState begun) {
        doTasks(stage);
        inbox.stateIf(begun::showsThePictureOf).ifPresent(same -> {
            state = same;
            map(stage, false);
        });
        return inbox.isInterrupted();
    }

    private void complete(Stage stage) {
        ViewState shown = state;
        Finished last = finished.get(shown.isOther());
        news.accept(to -> to.complete(shown, last.picture(), last.nanoseconds()));
        map(stage, true);
        stage.prefetch();
    }

    /** Draws the BRDF map. The picture does not wait for one that fails. */
    private void map(Stage stage, boolean isFinal) {
        ViewState shown = state;
        try {
            stage.map(
                    shown,
                    isFinal,
                    // The other of two methods comes after it.
                    () -> inbox.isInterrupted(newer -> !newer.isOther()),
                    (image, isWhole) -> news.accept(to -> to.map(shown, image, isWhole)));
        } catch (RuntimeException | OutOfMemoryError failure) {
            news.accept(to -> to.refused(Failure.of(failure).message()));
        }
    }
}
