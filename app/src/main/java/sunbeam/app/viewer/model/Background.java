package sunbeam.app.viewer.model;

import java.util.concurrent.Callable;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import sunbeam.app.commands.failure.Failure;

/** Work off the event thread, one after the other, whose outcomes come back on it. */
public final class Background implements AutoCloseable {
    private final ThreadPoolExecutor executor;

    public Background(String name) {
        executor = new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Does the work; afterwards, on the event thread, hands over its result or its problem in one line. Once closed, does
     * nothing: what the render thread says last may come after the window's end.
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

    /** Takes no more work, but does what there is. */
    public void finish() {
        executor.shutdown();
    }

    /** Waits until all is done that is done at all. Not on the event thread. */
    public void awaitEnd(long milliseconds) throws InterruptedException {
        executor.awaitTermination(milliseconds, TimeUnit.MILLISECONDS);
    }

    /** Drops what has not begun; what has is not interrupted, lest it complain of that. */
    @Override
    public void close() {
        executor.getQueue().clear();
        executor.shutdown();
    }
}
