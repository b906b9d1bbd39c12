package sunbeam.app.terminal.progress;

import java.time.Duration;
import java.util.Optional;

/**
 * How long a task still takes if the rest goes as fast as what is done since its first step, before which it may compile, transform or
 * read. Nothing is said of less than a twentieth.
 */
final class TimeLeft {
    private static final double LEAST_SHARE = 0.05;

    private double firstDone;
    private Duration firstTime = Duration.ZERO;

    /**
     * The estimate.
     *
     * @param done share of the task, 0 to 1, at least that of the call before
     * @param elapsed since its start
     */
    synchronized Optional<Duration> at(double done, Duration elapsed) {
        if (done >= 1) {
            return Optional.of(Duration.ZERO);
        }
        if (firstDone == 0) {
            firstDone = done;
            firstTime = elapsed;
        }
        double share = done - firstDone;
        if (share < LEAST_SHARE) {
            return Optional.empty();
        }
        return Optional.of(Duration.ofMillis(Math.round(elapsed.minus(firstTime).toMillis() * (1 - done) / share)));
    }
}
