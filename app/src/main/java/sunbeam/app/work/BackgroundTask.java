package sunbeam.app.work;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ForkJoinPool;
import java.util.function.Supplier;

/**
 * Computation in a pool of threads, while the caller does something else. Two computations that are partly serial take less time in
 * parallel. The pool is not the common one, which on two processors has one thread. Threads outside of that pool that run parallel
 * streams share one of its queues. In Java 17 they wait for each other in a loop that takes a whole processor.
 */
public record BackgroundTask<T>(CompletableFuture<T> future) {
    private static final ForkJoinPool POOL = new ForkJoinPool();

    public static <T> BackgroundTask<T> start(Supplier<T> work) {
        return new BackgroundTask<>(CompletableFuture.supplyAsync(work, POOL));
    }

    /** Starts another computation when this one has ended, with or without failure. No thread of the pool waits meanwhile. */
    public <R> BackgroundTask<R> then(Supplier<R> work) {
        return new BackgroundTask<>(future.handleAsync((result, failure) -> work.get(), POOL));
    }

    /** Throws the exception of the computation if it failed. */
    public T get() {
        try {
            return future.join();
        } catch (CompletionException failure) {
            if (failure.getCause() instanceof Error error) {
                throw error;
            }
            throw failure.getCause() instanceof RuntimeException cause ? cause : failure;
        }
    }

    /** Waits for the end and drops result or failure, for a caller that has itself failed meanwhile. */
    public void settle() {
        future.exceptionally(failure -> null).join();
    }
}
