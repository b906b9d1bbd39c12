package sunbeam.app.terminal;

import java.time.Duration;
import java.util.Deque;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBarConsumer;

/**
 * The line that shows a task's progress. On a terminal it is drawn over and over, and erased at the end; elsewhere copies of it are printed, a
 * few a minute. Of several open ones, as of a task that is part of another, the newest is drawn.
 */
final class ProgressLine implements ProgressBarConsumer {
    static final Duration INTERVAL = Duration.ofSeconds(10);

    private final Terminal terminal;
    private final LongSupplier nanoseconds;
    private final AtomicLong lastPrinted;
    private final Deque<ProgressLine> open;
    private final long start;
    private int drawn;
    private boolean closed;

    /**
     * Opens a line.
     *
     * @param lastPrinted time at which any task's line was printed
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

    /** Returns one less than the terminal has: some terminals wrap in the last column. */
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
            long now = nanoseconds.getAsLong();
            long before = lastPrinted.get();
            if (now - before >= INTERVAL.toNanos() && lastPrinted.compareAndSet(before, now)) {
                print("sunbeam: " + text.strip() + System.lineSeparator());
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
        closed = true;
        open.remove(this);
    }

    private void print(String text) {
        terminal.stream().print(text);
        terminal.stream().flush();
    }
}
