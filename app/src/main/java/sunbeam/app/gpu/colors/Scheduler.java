package sunbeam.app.gpu.colors;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;

/**
 * Has those tiles of a color table made that were requested last: the most urgent first, one job at a time, by an executor. A job that
 * something more urgent overtakes is canceled, and taken up again later. No lock is held while tiles are made or read, or while anybody
 * is told of them. Thread-safe.
 */
final class Scheduler implements AutoCloseable {
    private static final int COARSEST = 0;
    private static final int PREFETCHED = 2;

    /**
     * Tiles that have been made.
     *
     * @param coefficients of each tile, in the order of their numbers
     */
    record Made(TileMaker.Job job, List<byte[]> coefficients) {}

    /**
     * What is due.
     *
     * @param priority index in {@link FrameRequest#byPriority()}
     * @param missing of that priority
     */
    private record Due(int priority, TileSet missing, CancellationToken token) {}

    /** What is done while nothing else is due; canceled when something is. */
    private record Idle(CancellationToken token, Runnable task) {}

    private enum Life {
        OPEN,
        CLOSING,
        CLOSED
    }

    private final TileMaker maker;
    private final Executor executor;
    private final Runnable arrived;
    // All below is guarded by this.
    private final TileSet made;
    private final Deque<Made> untaken = new ArrayDeque<>();
    private final Deque<Idle> idleTasks = new ArrayDeque<>();
    private FrameRequest request;
    private Optional<Due> running = Optional.empty();
    private Optional<Idle> idling = Optional.empty();
    private Optional<Throwable> failure = Optional.empty();
    // Whether the executor has been given a turn that has not ended.
    private boolean isQueued;
    private boolean isInteractive;
    private Life life = Life.OPEN;

    /**
     * Nothing is requested yet.
     *
     * @param levels of the table
     * @param maker used, and closed in the end, by the executor alone
     * @param executor runs one thing at a time, in the order in which they came
     * @param arrived told, by the executor, that {@link #take()} has something
     */
    Scheduler(int levels, TileMaker maker, Executor executor, Runnable arrived) {
        this.maker = maker;
        this.executor = executor;
        this.arrived = arrived;
        this.made = TileSet.none(levels);
        this.request = FrameRequest.none(levels);
    }

    /** Asks for tiles, in the place of those that were asked for before. What has been made is not made again. */
    synchronized void request(FrameRequest next) {
        request = next;
        reconsider();
    }

    /** Whether something moves: then nothing is made but what every picture falls back on. */
    synchronized void interactive(boolean value) {
        isInteractive = value;
        reconsider();
    }

    /** Does something once the picture's tiles are made and nothing moves, once at most; canceled when more is due. */
    synchronized void whenIdle(CancellationToken token, Runnable task) {
        idleTasks.add(new Idle(token, task));
        reconsider();
    }

    /** What has been made and was not taken yet. What kept tiles from being made is thrown, once; they may be requested again. */
    synchronized Optional<Made> take() {
        Optional<Throwable> reported = untaken.isEmpty() ? failure : Optional.empty();
        if (reported.isPresent()) {
            failure = Optional.empty();
            if (reported.get() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) reported.get();
        }
        return Optional.ofNullable(untaken.poll());
    }

    /** Cancels the job at hand; the executor closes the maker after it. */
    @Override
    public synchronized void close() {
        if (life == Life.OPEN) {
            life = Life.CLOSING;
            untaken.clear();
            failure = Optional.empty();
            reconsider();
        }
    }

    /** Guarded by this. Cancels the job at hand unless it is still the first, and has the executor begin where there is something to do. */
    private void reconsider() {
        Optional<Due> first = first();
        running.filter(job -> !first.map(due -> isPartOf(job, due)).orElse(false))
                .ifPresent(job -> job.token().cancel());
        idling.filter(task -> life != Life.OPEN || isInteractive || !isComplete(first))
                .ifPresent(task -> task.token().cancel());
        boolean isDue = life == Life.CLOSING || first.isPresent() || mayIdle(first);
        if (isDue && !isQueued) {
            isQueued = true;
            executor.execute(this::turn);
        }
    }

    private static boolean isPartOf(Due job, Due due) {
        return job.priority() == due.priority()
                && job.missing().without(due.missing()).isEmpty();
    }

    /** Guarded by this. What is missing of the most urgent priority that has anything missing and may be made now. */
    private Optional<Due> first() {
        List<TileSet> byPriority = life == Life.OPEN ? request.byPriority() : List.of();
        int end = isInteractive ? Math.min(COARSEST + 1, byPriority.size()) : byPriority.size();
        for (int priority = COARSEST; priority < end; priority++) {
            TileSet missing = byPriority.get(priority).without(made);
            if (!missing.isEmpty()) {
                return Optional.of(new Due(priority, missing, new CancellationToken()));
            }
        }
        return Optional.empty();
    }

    /** Guarded by this. */
    private boolean mayIdle(Optional<Due> first) {
        return life == Life.OPEN && isComplete(first) && !isInteractive && !idleTasks.isEmpty();
    }

    private static boolean isComplete(Optional<Due> first) {
        return first.map(due -> due.priority() == PREFETCHED).orElse(true);
    }

    /** By the executor: does what is due first, and has it do the next. */
    private void turn() {
        next().run();
        if (endTurn()) {
            maker.close();
        }
    }

    /** Whether it was the last, in which the maker is closed: its owner's executor may take nothing more. */
    private synchronized boolean endTurn() {
        running = Optional.empty();
        idling = Optional.empty();
        if (life == Life.CLOSING) {
            life = Life.CLOSED;
            return true;
        }
        isQueued = false;
        reconsider();
        return false;
    }

    private synchronized Runnable next() {
        Optional<Due> first = first();
        if (mayIdle(first)) {
            Idle task = idleTasks.remove();
            idling = Optional.of(task);
            return () -> idle(task);
        }
        running = first;
        return () -> first.ifPresent(this::make);
    }

    private void make(Due due) {
        try {
            TileMaker.Job job = maker.next(due.missing());
            due.token().check();
            deliver(new Made(job, maker.make(job, due.token())));
        } catch (RuntimeException | Error problem) {
            if (due.token().isCancelled()) {
                return; // somebody else's turn
            }
            fail(problem, true);
        }
        arrived.run();
    }

    private void idle(Idle idle) {
        try {
            if (!idle.token().isCancelled()) {
                idle.task().run();
            }
        } catch (RuntimeException | Error problem) {
            if (idle.token().isCancelled()) {
                return;
            }
            fail(problem, false);
            arrived.run();
        }
    }

    private synchronized void deliver(Made tiles) {
        if (life == Life.OPEN) {
            made.of(tiles.job().level()).or(tiles.job().tiles());
            untaken.add(tiles);
        }
    }

    /** @param givesUp whether nothing more is made before it is asked for again */
    private synchronized void fail(Throwable problem, boolean givesUp) {
        if (life == Life.OPEN) {
            failure = Optional.of(problem);
        }
        if (givesUp) {
            request = FrameRequest.none(made.levels());
        }
    }
}
