package sunbeam.app.viewer;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ForkJoinPool;
import java.util.function.Supplier;

/**
 * Work that leaves half of the processors to what is being drawn meanwhile, and all of them while something moves, as far as it asks
 * ({@link #pause}).
 */
final class Sparing {
    // Whoever moves something rests for less between two drags.
    private static final long STILL_NANOSECONDS = 1_500_000_000;

    private long heldUntil = System.nanoTime();

    /** Something moves, or may in a moment. */
    synchronized void hold() {
        heldUntil = System.nanoTime() + STILL_NANOSECONDS;
    }

    /** Returns when nothing has moved for a while. */
    synchronized void pause() {
        try {
            for (long left = milliseconds(); left > 0; left = milliseconds()) {
                wait(left);
            }
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    /** Guarded by this; rounded up. */
    private long milliseconds() {
        return (heldUntil - System.nanoTime() + 999_999) / 1_000_000;
    }

    /** Does the work, parallel streams in it included, and waits for it. What it throws is thrown. */
    static <T> T call(Supplier<T> work) {
        ForkJoinPool some = new ForkJoinPool(Math.max(1, Runtime.getRuntime().availableProcessors() / 2));
        try {
            return CompletableFuture.supplyAsync(work, some).join();
        } catch (CompletionException failure) {
            if (failure.getCause() instanceof RuntimeException problem) {
                throw problem;
            }
            if (failure.getCause() instanceof Error problem) {
                throw problem;
            }
            throw failure;
        } finally {
            some.shutdown();
        }
    }
}
