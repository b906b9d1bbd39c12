package sunbeam.app.commands.figures;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;

/** Tells how far the figures are: a line for each picture, with the time left. */
final class Journal {
    private final PrintWriter err;
    private final int total;
    private final long start = System.nanoTime();
    private int done;

    Journal(PrintWriter err, int total) {
        this.err = err;
        this.total = total;
    }

    void finished(Panel panel) {
        done++;
        long left = (System.nanoTime() - start) / done * (total - done);
        Duration time = Duration.ofNanos(left);
        err.println(String.format(
                Locale.ROOT,
                "%3d of %d: %s (about %d:%02d left)",
                done,
                total,
                panel.name(),
                time.toMinutes(),
                time.toSecondsPart()));
        err.flush();
    }
}
