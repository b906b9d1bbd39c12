package sunbeam.app.terminal.progress;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import me.tongfei.progressbar.ProgressState;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.precompute.colortable.BakeToken;

/**
 * How far a long task is, with the time left, on standard error, only once the task has taken 2 s: on a terminal one line, gone
 * when the task ends; elsewhere lines, one every 10 s at most, however many tasks follow each other. Thread-safe.
 */
public final class Progress implements BakeToken {
    static final Duration DELAY = Duration.ofSeconds(2);
    private static final double LEAST_DONE = 0.02;
    private static final int REDRAW_MILLISECONDS = 200;

    /** Of the process, as its standard error is. */
    private static volatile boolean quiet;

    /** When a line that stays was printed; of the process, too. */
    private static final AtomicLong LAST = new AtomicLong(System.nanoTime());

    private final ProgressLine line;
    private final ProgressBar bar;
    private final ShutdownHook hook;

    private Progress(ProgressLine line, ProgressBar bar, ShutdownHook hook) {
        this.line = line;
        this.bar = bar;
        this.hook = hook;
    }

    /** Whether the user wants to see none ({@code --quiet}); concerns tasks that start later. */
    public static void setQuiet(boolean wanted) {
        quiet = wanted;
    }

    /** Of a task that shows none. */
    public static Progress none() {
        return new Progress(null, null, null);
    }

    /**
     * Starts a task. While another one is under way, only the one that was started last is shown.
     *
     * @param label what is being done, for example {@code rendering}
     * @param total number of steps, at least 0
     */
    public static Progress start(String label, long total) {
        return start(label, total, Terminal.ofStandardError(System.getenv()), System::nanoTime, LAST);
    }

    static Progress start(String label, long total, Terminal terminal, LongSupplier nanoseconds, AtomicLong last) {
        if (quiet) {
            return none();
        }
        ProgressLine line = new ProgressLine(terminal, nanoseconds, last);
        // On Ctrl-C the half-drawn line goes, and none is drawn after it.
        ShutdownHook hook = new ShutdownHook(line::close);
        ProgressBar bar = new ProgressBarBuilder()
                .setTaskName(label)
                .setInitialMax(total)
                .setUpdateIntervalMillis(REDRAW_MILLISECONDS)
                .setStyle(ProgressBarStyle.ASCII)
                .setEtaFunction(Progress::left)
                .setConsumer(line)
                .build();
        return new Progress(line, bar, hook);
    }

    /** The results of a task for each item, in parallel, each of which is a step. */
    public static <T, R> List<R> map(String label, List<T> items, Function<T, R> task) {
        try (Progress progress = start(label, items.size())) {
            return items.parallelStream()
                    .map(item -> {
                        R result = task.apply(item);
                        progress.step(1);
                        return result;
                    })
                    .toList();
        }
    }

    /** As long for each step as so far; unknown at the start, whose steps tell little. */
    private static Optional<Duration> left(ProgressState state) {
        double done = state.getNormalizedProgress();
        Duration elapsed = state.getElapsedAfterStart();
        return done < LEAST_DONE || elapsed.compareTo(DELAY) < 0
                ? Optional.empty()
                : Optional.of(Duration.ofSeconds(Math.round(elapsed.toSeconds() * (1 / done - 1))));
    }

    /** More steps are done. */
    @Override
    public void step(long count) {
        if (bar != null) {
            bar.stepBy(count);
        }
    }

    /** The task has ended, well or not. */
    @Override
    public void close() {
        if (bar != null) {
            bar.close();
            line.close();
            hook.close();
        }
    }
}
