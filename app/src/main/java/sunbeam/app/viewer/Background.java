package sunbeam.app.viewer;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Work off the event thread, one after the other, whose outcomes come back on it. */
final class Background implements AutoCloseable {
    private final ExecutorService executor;

    Background(String name) {
        executor = Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Does the work; afterwards, on the event thread, hands over its result or its problem in one line. Once closed, does
     * nothing: what the render thread says last may come after the window's end.
     */
    <T> void run(Callable<T> work, Consumer<T> done, Consumer<String> problem) {
        if (executor.isShutdown()) {
            return;
        }
        executor.execute(() -> {
            try {
                T result = work.call();
                SwingUtilities.invokeLater(() -> done.accept(result));
            } catch (Exception | OutOfMemoryError failure) {
                String message = Problems.message(failure);
                SwingUtilities.invokeLater(() -> problem.accept(message));
            }
        });
    }

    /** Drops what has not begun. */
    @Override
    public void close() {
        executor.shutdownNow();
    }
}
