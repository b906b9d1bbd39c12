package sunbeam.app.terminal.progress;

import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBarConsumer;

/** The one line of a terminal that progress is drawn on, over and over; it leaves nothing behind. */
final class ProgressLine implements ProgressBarConsumer {
    private final Terminal terminal;
    private final LongSupplier nanoseconds;
    private final long start;
    private int drawn;
    private boolean closed;

    ProgressLine(Terminal terminal, LongSupplier nanoseconds) {
        this.terminal = terminal;
        this.nanoseconds = nanoseconds;
        this.start = nanoseconds.getAsLong();
    }

    /** One less than the terminal has: in the last column some terminals wrap. */
    @Override
    public int getMaxRenderedLength() {
        return terminal.columns() - 1;
    }

    @Override
    public synchronized void accept(String text) {
        if (closed || nanoseconds.getAsLong() - start < Progress.DELAY.toNanos()) {
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
    }

    private void print(String text) {
        terminal.stream().print(text);
        terminal.stream().flush();
    }
}
