package sunbeam.app.viewer;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ForkJoinPool;
import java.util.function.Supplier;

/** Work that leaves half of the processors to what is being drawn meanwhile. */
final class Sparing {
    private Sparing() {}

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
