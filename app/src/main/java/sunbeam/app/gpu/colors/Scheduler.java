package sunbeam.app.gpu.colors;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.stream.IntStream;
import sunbeam.app.work.CancellationToken;

/**
 * Schedules baking on an executor, the most urgent tiles first. A more urgent request cancels the running job, which is resumed later.
 * Baking, reading and callbacks hold no lock. Thread-safe.
 */
final class Scheduler implements AutoCloseable {
    private static final int COARSEST = 0;
    private static final int PREFETCHED = 2;

    /** @param coefficients one array per tile, in the order of the tiles' numbers */
    record BakedTiles(int level, BitSet tiles, List<byte[]> coefficients) {}

    /** Not thread-safe. */
    interface TileBaker extends AutoCloseable {
        /** Bakes or reads some of the missing tiles, one or more, or throws CancellationException; finished samples are reused. */
        BakedTiles bake(TileSet missing, CancellationToken token);

        @Override
        void close();
    }

    /** @param priority index in the request */
    private record DueJob(int priority, TileSet missing, CancellationToken token) {}

    private record IdleTask(CancellationToken token, Runnable task) {}

    private final TileBaker baker;
    private final Executor executor;
    private final Runnable onBakedTiles;
    // Guarded by this, like all fields below.
    private List<TileSet> missing = List.of();
    private final Deque<BakedTiles> undelivered = new ArrayDeque<>();
    private final Deque<IdleTask> idleTasks = new ArrayDeque<>();
    private Optional<DueJob> running = Optional.empty();
    private Optional<IdleTask> idling = Optional.empty();
    private Optional<Throwable> failure = Optional.empty();
    // True from the submission of turn() until it has run.
    private boolean isQueued;
    private boolean isInteractive;
    private boolean isClosing;

    /** The executor runs tasks in order, one at a time; it alone uses and closes the baker, and calls back when poll() has tiles. */
    Scheduler(TileBaker baker, Executor executor, Runnable onBakedTiles) {
        this.baker = baker;
        this.executor = executor;
        this.onBakedTiles = onBakedTiles;
    }

    /**
     * Requests tiles that {@link #poll()} has not returned, in place of the last request.
     *
     * @param byPriority tiles of the coarsest level, which replace missing finer ones and are baked even while something moves; those of
     *     the still picture; those that the next picture may read
     */
    synchronized void request(List<TileSet> byPriority) {
        missing = byPriority.stream().map(TileSet::copy).toList();
        undelivered.forEach(this::removeFromMissing);
        reconsider();
    }

    private void removeFromMissing(BakedTiles baked) {
        missing.forEach(tiles -> tiles.of(baked.level()).andNot(baked.tiles()));
    }

    /** Sets whether something moves; then only tiles of the coarsest priority are baked. */
    synchronized void interactive(boolean value) {
        isInteractive = value;
        reconsider();
    }

    /** Runs a task at most once, when the picture's tiles are baked and nothing moves, before prefetching; a due job cancels it. */
    synchronized void whenIdle(CancellationToken token, Runnable task) {
        idleTasks.add(new IdleTask(token, task));
        reconsider();
    }

    /** Returns new baked tiles. Throws a failure of baking once; its tiles may be requested again. */
    synchronized Optional<BakedTiles> poll() {
        if (undelivered.isEmpty() && failure.isPresent()) {
            Throwable reported = failure.get();
            failure = Optional.empty();
            if (reported instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) reported;
        }
        return Optional.ofNullable(undelivered.poll());
    }

    /** Cancels the running job; the executor closes the baker afterwards. */
    @Override
    public synchronized void close() {
        isClosing = true;
        undelivered.clear();
        failure = Optional.empty();
        reconsider();
    }

    /** Guarded by this. Cancels the running job if another or an idle task is more urgent, and submits {@link #turn} if anything is due. */
    private void reconsider() {
        Optional<DueJob> first = mostUrgent();
        running.filter(job ->
                        mayIdle(first) || !first.map(due -> isPartOf(job, due)).orElse(false))
                .ifPresent(job -> job.token().cancel());
        idling.filter(task -> isClosing || isInteractive || !isComplete(first))
                .ifPresent(task -> task.token().cancel());
        if (!isQueued && (isClosing || first.isPresent() || mayIdle(first))) {
            isQueued = true;
            executor.execute(this::turn);
        }
    }

    private static boolean isPartOf(DueJob job, DueJob due) {
        return job.priority() == due.priority()
                && job.missing().without(due.missing()).isEmpty();
    }

    /** Guarded by this. */
    private Optional<DueJob> mostUrgent() {
        return IntStream.range(COARSEST, isClosing ? 0 : missing.size())
                .filter(priority -> !isInteractive || priority == COARSEST)
                .filter(priority -> !missing.get(priority).isEmpty())
                .mapToObj(priority -> new DueJob(priority, missing.get(priority).copy(), new CancellationToken()))
                .findFirst();
    }

    /** Guarded by this. */
    private boolean mayIdle(Optional<DueJob> first) {
        return !isClosing && isComplete(first) && !isInteractive && !idleTasks.isEmpty();
    }

    private static boolean isComplete(Optional<DueJob> first) {
        return first.map(due -> due.priority() == PREFETCHED).orElse(true);
    }

    /** Performs the most urgent job, or an idle task, on the executor, and submits itself again if more is due. */
    private void turn() {
        next().run();
        if (endTurn()) {
            baker.close();
        }
    }

    /** True if this was the last turn: the caller closes the baker, since the executor may accept no further task. */
    private synchronized boolean endTurn() {
        running = Optional.empty();
        idling = Optional.empty();
        // After the last turn isQueued stays true, so that none follows.
        isQueued = isClosing;
        reconsider();
        return isClosing;
    }

    private synchronized Runnable next() {
        Optional<DueJob> first = mostUrgent();
        if (mayIdle(first)) {
            IdleTask task = idleTasks.remove();
            idling = Optional.of(task);
            return () -> idle(task);
        }
        running = first;
        return () -> first.ifPresent(this::bake);
    }

    private void bake(DueJob due) {
        try {
            deliver(baker.bake(due.missing(), due.token()));
        } catch (RuntimeException | Error problem) {
            if (due.token().isCancelled()) {
                return; // a more urgent job follows
            }
            fail(problem, true);
        }
        onBakedTiles.run();
    }

    private void idle(IdleTask idle) {
        try {
            if (!idle.token().isCancelled()) {
                idle.task().run();
            }
        } catch (RuntimeException | Error problem) {
            if (idle.token().isCancelled()) {
                return;
            }
            fail(problem, false);
            onBakedTiles.run();
        }
    }

    private synchronized void deliver(BakedTiles tiles) {
        if (!isClosing) {
            removeFromMissing(tiles);
            undelivered.add(tiles);
        }
    }

    private synchronized void fail(Throwable problem, boolean givesUp) {
        if (!isClosing) {
            failure = Optional.of(problem);
        }
        if (givesUp) {
            missing = List.of();
        }
    }
}
