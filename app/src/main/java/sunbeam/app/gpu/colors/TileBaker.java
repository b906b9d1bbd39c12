package sunbeam.app.gpu.colors;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.TimeUnit;

/**
 * Makes tiles of levels on a thread of its own, some at a time: those that were asked for last. It keeps one processor busy, all
 * where nothing has moved for a while, and none while {@link #hold} says that pictures are being drawn: what is being made by rays
 * pauses after the ray at hand, and goes on as it was begun.
 */
final class TileBaker implements AutoCloseable {
    // Tiles that are made at once by one processor, and by all: a second's work or two, for which waits what is
    // asked for meanwhile. The fewer, the more rays are evaluated for several of them.
    private static final int CHUNK = 1200;
    private static final int CHUNK_OF_ALL = 9600;
    // Tiles that are read at once: some tenths of a second of work, which nothing that moves waits for.
    private static final int MOST_AT_ONCE = 4000;
    private static final int LIFE_DAYS = 1000;
    private static final long HOLD_NANOSECONDS = 300_000_000;
    // Nothing has moved for so long: what stands still may as well have all processors.
    private static final long STILL_NANOSECONDS = 2_000_000_000;
    // What nobody waits for leaves the processors to whoever draws what has just been made, or asks for more.
    private static final long LATER_NANOSECONDS = 1_500_000_000;
    private static final long PATIENCE_MILLISECONDS = 5000;

    /**
     * Tiles that have been made.
     *
     * @param level of the tiles
     * @param tiles their numbers
     * @param coefficients of each tile
     */
    record Baked(int level, int[] tiles, List<byte[]> coefficients) {}

    /**
     * Tiles that are to be made.
     *
     * @param level of the tiles
     * @param tiles their numbers
     * @param spread over all processors
     */
    private record Due(int level, int[] tiles, boolean spread) {}

    private final TileSources sources;
    private final Runnable arrived;
    private final Queue<Baked> baked = new ConcurrentLinkedQueue<>();
    // What has been begun or made, by level.
    private final List<BitSet> done = new ArrayList<>();
    // One, so that the others are left to what is drawn meanwhile; and always the same, to which sources may belong.
    private final ForkJoinPool processor = new ForkJoinPool(
            1, ForkJoinPool.defaultForkJoinWorkerThreadFactory, null, false, 1, 1, 0, null, LIFE_DAYS, TimeUnit.DAYS);
    private final Thread thread;
    // Guarded by this.
    private List<BitSet> wanted = List.of();
    private List<BitSet> later = List.of();
    private long heldUntil = System.nanoTime() - STILL_NANOSECONDS;
    // Whether what was begun last is waited for; when what is not may be begun.
    private boolean isUrgent = true;
    private long laterFrom;
    private boolean closed;
    private Throwable failure;

    /**
     * Begins.
     *
     * @param arrived told, on the baker's thread, that there is something to {@link #poll()}
     */
    TileBaker(TileSources sources, Runnable arrived) {
        this.sources = sources;
        this.arrived = arrived;
        sources.grids().forEach(grid -> done.add(new BitSet()));
        this.thread = new Thread(this::run, "colors");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Asks for tiles, in the place of those that were asked for before.
     *
     * @param tiles by level
     * @param afterwards tiles by level that are made when those are there
     */
    synchronized void want(List<BitSet> tiles, List<BitSet> afterwards) {
        wanted = tiles;
        later = afterwards;
        notifyAll();
    }

    /** Validates what has been made, after the tiles at hand. */
    void validate(FootprintSample.Tabulated sample) {
        processor.execute(() -> sources.validate(sample));
    }

    /** Pictures are being drawn: leaves the processors to them for a while. */
    synchronized void hold() {
        heldUntil = System.nanoTime() + HOLD_NANOSECONDS;
    }

    /** In the middle of what is being made. */
    private synchronized void waitWhileHeld() {
        try {
            for (long held = heldFor(); held > 0 && !closed; held = heldFor()) {
                wait(held);
            }
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        }
        if (closed) {
            throw new IllegalStateException("nobody waits for these colors any more");
        }
    }

    /** Guarded by this. Milliseconds, rounded up; none where it is not positive. */
    private long heldFor() {
        return millisecondsUntil(heldUntil);
    }

    private static long millisecondsUntil(long nanoTime) {
        return (nanoTime - System.nanoTime() + 999_999) / 1_000_000;
    }

    /**
     * What has been made and was not told yet. What kept tiles from being made is thrown, once; they may be asked for again.
     */
    Optional<Baked> poll() {
        Optional<Baked> next = Optional.ofNullable(baked.poll());
        if (next.isEmpty()) {
            throwFailure();
        }
        return next;
    }

    private synchronized void throwFailure() {
        Throwable told = failure;
        failure = null;
        if (told instanceof Error error) {
            throw error;
        }
        if (told instanceof RuntimeException exception) {
            throw exception;
        }
    }

    private void run() {
        try {
            for (Due due = next(); due != null; due = next()) {
                make(due);
                arrived.run();
            }
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        } finally {
            // Some sources belong to the thread that opened them.
            processor.submit(sources::close).join();
            processor.shutdown();
        }
    }

    private void make(Due due) {
        BitSet tiles = new BitSet();
        Arrays.stream(due.tiles()).forEach(tiles::set);
        int level = due.level();
        try {
            List<byte[]> coefficients = due.spread()
                    ? sources.bake(level, tiles, this::waitWhileHeld)
                    : CompletableFuture.supplyAsync(() -> sources.bake(level, tiles, this::waitWhileHeld), processor)
                            .join();
            baked.add(new Baked(level, due.tiles(), coefficients));
        } catch (CompletionException problem) {
            giveUp(level, tiles, problem.getCause());
        } catch (RuntimeException | Error problem) {
            giveUp(level, tiles, problem);
        }
    }

    /** Guarded by this. Whether all processors may work: levels are made by the processors alone, and nothing moves. */
    private boolean maySpread() {
        return sources.grids().size() > 1 && System.nanoTime() - heldUntil > STILL_NANOSECONDS;
    }

    /** Nothing more is made before it is asked for again. */
    private synchronized void giveUp(int level, BitSet tiles, Throwable problem) {
        done.get(level).andNot(tiles);
        wanted = List.of();
        later = List.of();
        failure = problem;
    }

    /** Waits for something to do; null in the end. */
    private synchronized Due next() throws InterruptedException {
        while (!closed) {
            long held = heldFor();
            if (held > 0) {
                wait(held);
                continue;
            }
            Optional<Due> due = due(wanted);
            if (due.isPresent()) {
                isUrgent = true;
            } else {
                if (isUrgent) {
                    isUrgent = false;
                    laterFrom = System.nanoTime() + LATER_NANOSECONDS;
                }
                due = due(later);
                long early = millisecondsUntil(laterFrom);
                if (due.isPresent() && early > 0) {
                    wait(early);
                    continue;
                }
            }
            if (due.isPresent()) {
                Arrays.stream(due.get().tiles()).forEach(done.get(due.get().level())::set);
                return due.get();
            }
            wait();
        }
        return null;
    }

    /** Guarded by this. What an earlier run has made comes first, then coarse levels before fine ones. */
    private Optional<Due> due(List<BitSet> asked) {
        boolean spread = maySpread();
        for (int level = asked.size() - 1; level >= 0; level--) {
            BitSet cached = sources.cached(level, missing(asked, level));
            if (!cached.isEmpty()) {
                int[] tiles = cached.stream().limit(MOST_AT_ONCE).toArray();
                return Optional.of(new Due(level, tiles, spread));
            }
        }
        int chunk = spread ? CHUNK_OF_ALL : CHUNK;
        for (int level = asked.size() - 1; level >= 0; level--) {
            BitSet missing = missing(asked, level);
            if (!missing.isEmpty()) {
                int[] tiles =
                        sources.grids().get(level).byAngle(missing).limit(chunk).toArray();
                return Optional.of(new Due(level, tiles, spread));
            }
        }
        return Optional.empty();
    }

    /** Guarded by this. */
    private BitSet missing(List<BitSet> asked, int level) {
        BitSet missing = (BitSet) asked.get(level).clone();
        missing.andNot(done.get(level));
        return missing;
    }

    /** Gives up the tiles at hand. */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            notifyAll();
        }
        try {
            thread.join(PATIENCE_MILLISECONDS);
        } catch (InterruptedException interruption) {
            Thread.currentThread().interrupt();
        }
    }
}
