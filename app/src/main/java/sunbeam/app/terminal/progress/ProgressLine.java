package sunbeam.app.terminal.progress;

import java.time.Duration;
import java.util.Deque;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBarConsumer;

/**
 * The one line of a terminal that progress is drawn on, over and over; it leaves nothing behind. Where no terminal is, lines that
 * stay, a few a minute. Of several, as of a task that is part of another, the newest has the terminal.
 */
final class ProgressLine implements ProgressBarConsumer {
    static final Duration INTERVAL = Duration.ofSeconds(10);
    private static final Deque<ProgressLine> OPEN = new ConcurrentLinkedDeque<>();

    private final Terminal terminal;
    private final LongSupplier nanoseconds;
    private final AtomicLong last;
    private final long start;
    private int drawn;
    private boolean closed;

    /** @param last when a line that stays was printed, by any task */
    ProgressLine(Terminal terminal, LongSupplier nanoseconds, AtomicLong last) {
        this.last = last;
        this.terminal = terminal;
        this.nanoseconds = nanoseconds;
        this.start = nanoseconds.getAsLong();
        OPEN.addLast(this);
    }

    /** One less than the terminal has: in the last column some terminals wrap. */
    @Override
    public int getMaxRenderedLength() {
        return Terminal.COLUMNS - 1;
    }

    @Override
    public synchronized void accept(String text) {
        if (closed || OPEN.peekLast() != this || nanoseconds.getAsLong() - start < Progress.DELAY.toNanos()) {
            return;
        }
        if (!terminal.interactive()) {
            long now = nanoseconds.getAsLong();
            long before = last.get();
            if (now - before >= INTERVAL.toNanos() && last.compareAndSet(before, now)) {
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
        OPEN.remove(this);
    }

    private void print(String text) {
        terminal.stream().print(text);
        terminal.stream().flush();
    }
}
