package sunbeam.app.work;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;

/**
 * Something that is worked out while its caller does something else, by one of the threads that parallel loops share: two
 * pieces of work, each of which is partly no work for two processors, take less time beside each other.
 *
 * @param <T> what comes of it
 */
public final class BackgroundTask<T> {
    private final CompletableFuture<T> future;

    private BackgroundTask(CompletableFuture<T> future) {
        this.future = future;
    }

    /** Begins. */
    public static <T> BackgroundTask<T> start(Supplier<T> work) {
        return new BackgroundTask<>(CompletableFuture.supplyAsync(work));
    }

    /** Waits for its end; what it threw is thrown here. */
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

    /** Waits for its end, however it ends: for a caller who failed meanwhile. */
    public void settle() {
        future.exceptionally(failure -> null).join();
    }
}
