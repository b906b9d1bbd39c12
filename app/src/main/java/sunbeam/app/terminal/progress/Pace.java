package sunbeam.app.terminal.progress;

import java.time.Duration;
import java.util.function.LongSupplier;

/** When a line on progress may follow the last, or the start, where each stays: in a file, a pipe, a batch job's log. Thread-safe. */
final class Pace {
    static final Duration INTERVAL = Duration.ofSeconds(10);

    private final LongSupplier nanoseconds;
    private long last;

    /** Starts now. */
    Pace(LongSupplier nanoseconds) {
        this.nanoseconds = nanoseconds;
        this.last = nanoseconds.getAsLong();
    }

    /** Whether it is time for a line, which the caller then prints. */
    synchronized boolean isDue() {
        long now = nanoseconds.getAsLong();
        if (now - last < INTERVAL.toNanos()) {
            return false;
        }
        last = now;
        return true;
    }
}
