package sunbeam.app.terminal;

import java.time.Duration;
import java.util.Optional;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import me.tongfei.progressbar.ProgressState;
import sunbeam.precompute.colortable.ColorBaker;

/** Progress of one long task. {@link ProgressDisplay} starts it; the task closes it at its end. Thread-safe. */
public final class Progress implements ColorBaker.Token {
    static final Duration DELAY = Duration.ofSeconds(2);
    // Share of the steps done from which the time left is estimated.
    private static final double LEAST_DONE = 0.02;
    private static final int REDRAW_MILLISECONDS = 200;

    private final ProgressDisplay.Line line;
    private final ProgressBar bar;
    private final ShutdownHook hook;

    private Progress(ProgressDisplay.Line line, ProgressBar bar, ShutdownHook hook) {
        this.line = line;
        this.bar = bar;
        this.hook = hook;
    }

    static Progress hidden() {
        return new Progress(null, null, null);
    }

    static Progress of(String label, long total, ProgressDisplay.Line line) {
        // On Ctrl-C the half-drawn line is erased, and none is drawn after it.
        ShutdownHook hook = new ShutdownHook(line::close);
        ProgressBar bar = new ProgressBarBuilder()
                .setTaskName(label)
                .setInitialMax(total)
                .setUpdateIntervalMillis(REDRAW_MILLISECONDS)
                .setStyle(ProgressBarStyle.ASCII)
                .setEtaFunction(Progress::timeLeft)
                .setConsumer(line)
                .build();
        return new Progress(line, bar, hook);
    }

    private static Optional<Duration> timeLeft(ProgressState state) {
        double done = state.getNormalizedProgress();
        Duration elapsed = state.getElapsedAfterStart();
        return done < LEAST_DONE || elapsed.compareTo(DELAY) < 0
                ? Optional.empty()
                : Optional.of(Duration.ofSeconds(Math.round(elapsed.toSeconds() * (1 / done - 1))));
    }

    @Override
    public void step(long count) {
        if (bar != null) {
            bar.stepBy(count);
        }
    }

    @Override
    public void close() {
        if (bar != null) {
            bar.close();
            line.close();
            hook.close();
        }
    }
}
