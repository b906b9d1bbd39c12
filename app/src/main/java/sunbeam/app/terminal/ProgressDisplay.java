package sunbeam.app.terminal;

import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.function.LongSupplier;

/**
 * Shows the progress of long tasks and the time left on standard error; the program has one display. A task is shown after 2 s; if several
 * run at a time, the one that started last. A terminal shows one line, erased when the task ends. Elsewhere lines are printed, one every 10
 * s at most, however many tasks follow each other. Thread-safe.
 */
public final class ProgressDisplay {
    private final Terminal terminal;
    private final LongSupplier nanoseconds;
    private final AtomicLong lastPrinted;
    private final Deque<ProgressLine> open = new ConcurrentLinkedDeque<>();
    private volatile boolean silent;

    ProgressDisplay(Terminal terminal, LongSupplier nanoseconds) {
        this.terminal = terminal;
        this.nanoseconds = nanoseconds;
        this.lastPrinted = new AtomicLong(nanoseconds.getAsLong());
    }

    /**
     * Creates a display on standard error.
     *
     * @param variables environment variables, of which {@code TERM} says whether lines can be erased
     */
    static ProgressDisplay ofStandardError(Map<String, String> variables) {
        return new ProgressDisplay(Terminal.ofStandardError(variables), System::nanoTime);
    }

    /** Hides all tasks that start later ({@code --quiet}). */
    public ProgressDisplay silence() {
        silent = true;
        return this;
    }

    /**
     * Starts a task.
     *
     * @param label name of the task, for example {@code rendering}
     * @param total number of steps, at least 0
     */
    public Progress start(String label, long total) {
        return silent ? Progress.hidden() : Progress.of(label, total, line());
    }

    ProgressLine line() {
        return new ProgressLine(terminal, nanoseconds, lastPrinted, open);
    }

    /** Returns the function's values of all items, computed in parallel, as a task with one step per item. */
    public <T, R> List<R> map(String label, List<T> items, Function<T, R> function) {
        try (Progress progress = start(label, items.size())) {
            return items.parallelStream()
                    .map(item -> {
                        R result = function.apply(item);
                        progress.step(1);
                        return result;
                    })
                    .toList();
        }
    }
}
