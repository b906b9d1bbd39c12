package sunbeam.app.terminal;

import java.time.Duration;
import java.util.Deque;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBarConsumer;

/**
 * Line that shows a task's progress. On a terminal it is redrawn in place, and erased at the end; elsewhere copies of it are printed, a few
 * a minute, and the last state of a task that has printed one. If several lines are open (for a task and its part), the newest is drawn.
 */
final class ProgressLine implements ProgressBarConsumer {
    /** Least time between printed lines if standard error is no terminal. */
    static final Duration INTERVAL = Duration.ofSeconds(10);

    private final Terminal terminal;
    private final LongSupplier nanoseconds;
    private final AtomicLong lastPrinted;
    private final Deque<ProgressLine> open;
    private final long start;
    private int drawn;
    private String printed = "";
    private String last = "";
    private boolean closed;

    /**
     * Opens a line.
     *
     * @param terminal stream to draw on
     * @param lastPrinted time at which a line was last printed, shared by all tasks
     * @param open lines of all tasks, the newest last
     */
    ProgressLine(Terminal terminal, LongSupplier nanoseconds, AtomicLong lastPrinted, Deque<ProgressLine> open) {
        this.lastPrinted = lastPrinted;
        this.open = open;
        this.terminal = terminal;
        this.nanoseconds = nanoseconds;
        this.start = nanoseconds.getAsLong();
        open.addLast(this);
    }

    /** Returns one character less than the terminal is wide: some terminals wrap in the last column. */
    @Override
    public int getMaxRenderedLength() {
        return Terminal.COLUMNS - 1;
    }

    @Override
    public synchronized void accept(String text) {
        if (closed || open.peekLast() != this || nanoseconds.getAsLong() - start < Progress.DELAY.toNanos()) {
            return;
        }
        if (!terminal.interactive()) {
            last = text.strip();
            long now = nanoseconds.getAsLong();
            long before = lastPrinted.get();
            if (now - before >= INTERVAL.toNanos() && lastPrinted.compareAndSet(before, now)) {
                printLast();
            }
            return;
        }
        String fitting = text.substring(0, Math.min(text.length(), getMaxRenderedLength()));
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
        terminal.stream().print(text);
        terminal.stream().flush();
    }
}
