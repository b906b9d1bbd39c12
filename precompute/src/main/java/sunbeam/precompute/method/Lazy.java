package sunbeam.precompute.method;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/** Value computed once, without a lock, by the first thread that needs it. After a failure the next call tries again. */
final class Lazy<T> {
    private final Supplier<T> maker;
    private final AtomicReference<FutureTask<T>> task = new AtomicReference<>();

    Lazy(Supplier<T> maker) {
        this.maker = maker;
    }

    T get() {
        FutureTask<T> own = new FutureTask<>(maker::get);
        FutureTask<T> first = task.compareAndExchange(null, own);
        FutureTask<T> current = first == null ? own : first;
        if (current == own) {
            own.run();
        }
        try {
            return current.get();
        } catch (ExecutionException failure) {
            task.compareAndSet(current, null);
            if (failure.getCause() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) failure.getCause();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while another thread made what this one needs", interrupted);
        }
    }
}
