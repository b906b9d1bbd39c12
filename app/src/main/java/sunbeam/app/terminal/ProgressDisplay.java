package sunbeam.app.terminal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarConsumer;
import me.tongfei.progressbar.ProgressBarStyle;
import me.tongfei.progressbar.ProgressState;
import sunbeam.precompute.work.Progress;

/**
 * Shows the progress of long tasks and the time left on standard error; the program has one display. A task is shown after 2 s; if several
 * run at a time, the one that started last. A terminal shows one line, erased when the task ends. Elsewhere lines are printed, one every 10
 * s at most, however many tasks follow each other. Thread-safe.
 */
public final class ProgressDisplay {
    /** Time after which a task is shown. */
    static final Duration DELAY = Duration.ofSeconds(2);

    /** Least time between printed lines if standard error is no terminal. */
    static final Duration INTERVAL = Duration.ofSeconds(10);

    // One character less than the narrowest terminals in use have: some wrap in the last column.
    private static final int COLUMNS = 79;
    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    private final PrintStream stream;
    private final boolean interactive;
    private final LongSupplier nanoseconds;
    private final AtomicLong lastPrinted;
    private final Deque<Line> open = new ConcurrentLinkedDeque<>();
    private volatile boolean silent;

    /** @param interactive whether the stream is a terminal, on which a line can be overwritten */
    ProgressDisplay(PrintStream stream, boolean interactive, LongSupplier nanoseconds) {
        this.stream = stream;
        this.interactive = interactive;
        this.nanoseconds = nanoseconds;
        this.lastPrinted = new AtomicLong(nanoseconds.getAsLong());
    }

    /** @param variables environment variables, of which {@code TERM} says whether lines can be erased */
    static ProgressDisplay ofStandardError(Map<String, String> variables) {
        boolean dumb = variables.getOrDefault("TERM", "dumb").equals("dumb");
        return new ProgressDisplay(System.err, !dumb && isErrorTerminal(), System::nanoTime);
    }

    /** Linux only; Java's {@code Console} tells this only of input and output together. */
    private static boolean isErrorTerminal() {
        try {
            String device = STANDARD_ERROR.toRealPath().toString();
            return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty") || device.equals("/dev/console");
        } catch (IOException unknown) {
            // Pipes and sockets have no path; other systems have no such file.
            return false;
        }
    }

    /** Hides all tasks that start later ({@code --quiet}). */
    public void silence() {
        silent = true;
    }

    /** Starts a task such as {@code rendering} with a number of steps, at least 0. */
    public Progress start(String label, long total) {
        return new DisplayedProgress(label, total, new Line());
    }

    /** In parallel, as a task with one step per item. */
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

    /** Line of a task: redrawn and at the end erased on a terminal; elsewhere copies are printed, if any then also the last state. */
    final class Line implements ProgressBarConsumer {
        private final long start = nanoseconds.getAsLong();
        private final boolean isHidden = silent;
        private int drawn;
        private String printed = "";
        private String last = "";
        private boolean closed;

        Line() {
            open.addLast(this);
        }

        @Override
        public int getMaxRenderedLength() {
            return COLUMNS;
        }

        @Override
        public synchronized void accept(String text) {
            boolean isShown = !closed && !isHidden && open.peekLast() == this;
            if (!isShown || nanoseconds.getAsLong() - start < DELAY.toNanos()) {
                return;
            }
            if (!interactive) {
                last = text.strip();
                long now = nanoseconds.getAsLong();
                long before = lastPrinted.get();
                if (now - before >= INTERVAL.toNanos() && lastPrinted.compareAndSet(before, now)) {
                    printLast();
                }
                return;
            }
            String fitting = text.substring(0, Math.min(text.length(), COLUMNS));
            print("\r" + fitting + " ".repeat(Math.max(0, drawn - fitting.length())));
            drawn = fitting.length();
        }

        @Override
        public synchronized void close() {
            if (!closed && drawn > 0) {
                print("\r" + " ".repeat(drawn) + "\r");
            }
            if (!closed && !printed.isEmpty() && !printed.equals(last)) {
                printLast();
            }
            closed = true;
            open.remove(this);
        }

        private void printLast() {
            print("sunbeam: " + last + System.lineSeparator());
            printed = last;
        }

        private void print(String text) {
            stream.print(text);
            stream.flush();
        }
    }

    private static final class DisplayedProgress implements Progress {
        // Share of the steps done from which the time left is estimated.
        private static final double LEAST_DONE = 0.02;
        private static final int REDRAW_MILLISECONDS = 200;

        private final Line line;
        private final ProgressBar bar;
        private final ShutdownHook hook;

        DisplayedProgress(String label, long total, Line line) {
            this.line = line;
            // On Ctrl-C the half-drawn line is erased, and none is drawn after it.
            hook = new ShutdownHook(line::close);
            bar = new ProgressBarBuilder()
                    .setTaskName(label)
                    .setInitialMax(total)
                    .setUpdateIntervalMillis(REDRAW_MILLISECONDS)
                    .setStyle(ProgressBarStyle.ASCII)
                    .setEtaFunction(DisplayedProgress::timeLeft)
                    .setConsumer(line)
                    .build();
        }

        private static Optional<Duration> timeLeft(ProgressState state) {
            double done = state.getNormalizedProgress();
            Duration elapsed = state.getElapsedAfterStart();
            return done < LEAST_DONE || elapsed.compareTo(DELAY) < 0
                    ? Optional.empty()
                    : Optional.of(Duration.ofSeconds(Math.round(elapsed.toSeconds() * (1 / done - 1))));
        }

        @Override
        public void step(long steps) {
            bar.stepBy(steps);
        }

        @Override
        public void close() {
            bar.close();
            line.close();
            hook.close();
        }
    }
}
