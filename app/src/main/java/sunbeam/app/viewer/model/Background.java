package sunbeam.app.viewer.model;

import java.util.concurrent.Callable;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import sunbeam.app.failure.Failure;

/** Sequential worker thread; results come back on the event thread. */
public final class Background implements Executor, AutoCloseable {
    private final ThreadPoolExecutor executor;

    public Background(String name) {
        executor = new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), work -> {
            Thread thread = new Thread(work, name);
            thread.setDaemon(true);
            return thread;
        });
    }

    @Override
    public void execute(Runnable work) {
        executor.execute(work);
    }

    /**
     * Queues work; {@code done} receives its result, or {@code problem} the message of its failure, on the event thread. After {@link
     * #close} this does nothing, since late notifications of the render thread may still call it.
     */
    public <T> void run(Callable<T> work, Consumer<T> done, Consumer<String> problem) {
        if (executor.isShutdown()) {
            return;
        }
        executor.execute(() -> {
            try {
                T result = work.call();
                SwingUtilities.invokeLater(() -> done.accept(result));
            } catch (Exception | OutOfMemoryError failure) {
                String message = Failure.of(failure).message();
                SwingUtilities.invokeLater(() -> problem.accept(message));
            }
        });
    }

    public void finish() {
        executor.shutdown();
    }

    /** Waits for the end of the queue. Must not be called on the event thread. */
    public void awaitEnd(long milliseconds) throws InterruptedException {
        executor.awaitTermination(milliseconds, TimeUnit.MILLISECONDS);
    }

    /** Drops queued work; running work is not interrupted, since it would report the interruption as a failure. */
    @Override
    public void close() {
        executor.getQueue().clear();
        executor.shutdown();
    }
}
