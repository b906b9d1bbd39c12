package sunbeam.app.terminal.progress;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import me.tongfei.progressbar.ProgressBarRenderer;
import me.tongfei.progressbar.ProgressState;

/** {@code rendering [=====>     ]  45 %, 12 s left}, in ASCII, which every terminal shows; a renderer a task. */
final class TimeLeftRenderer implements ProgressBarRenderer {
    private static final int FEWEST_BAR = 5;

    private final boolean withBar;
    private final TimeLeft timeLeft = new TimeLeft();

    /** @param withBar else {@code rendering: 45 %, 12 s left} */
    TimeLeftRenderer(boolean withBar) {
        this.withBar = withBar;
    }

    @Override
    public String render(ProgressState state, int maxLength) {
        double done = state.getMax() == 0 ? 1 : Math.min(1, state.getCurrent() / (double) state.getMax());
        Optional<Duration> left = timeLeft.at(done, state.getElapsedAfterStart());
        return withBar ? render(state.getTaskName(), done, left, maxLength) : plain(state.getTaskName(), done, left);
    }

    static String render(String label, double done, Optional<Duration> left, int maxLength) {
        String figures = String.format(Locale.ROOT, " %3.0f %%%s", percent(done), words(left));
        int room = maxLength - label.length() - figures.length() - " []".length();
        if (room < FEWEST_BAR) {
            // Of a long name of a file its start; how far and how long stay.
            int most = Math.max(0, maxLength - figures.length());
            return (label.length() > most ? label.substring(0, Math.max(0, most - 2)) + ".." : label) + figures;
        }
        int filled = (int) (room * done);
        String arrow = filled < room ? "=".repeat(filled) + ">" + " ".repeat(room - filled - 1) : "=".repeat(room);
        return label + " [" + arrow + "]" + figures;
    }

    static String plain(String label, double done, Optional<Duration> left) {
        return String.format(Locale.ROOT, "%s: %.0f %%%s", label, percent(done), words(left));
    }

    private static double percent(double done) {
        return Math.floor(100 * done);
    }

    private static String words(Optional<Duration> left) {
        return left.map(time -> ", " + words(Math.round(time.toMillis() / 1000.0)))
                .orElse("");
    }

    private static String words(long seconds) {
        if (seconds < 60) {
            return seconds + " s left";
        }
        if (seconds < 3600) {
            return String.format(Locale.ROOT, "%d:%02d min left", seconds / 60, seconds % 60);
        }
        return String.format(Locale.ROOT, "%d:%02d h left", seconds / 3600, seconds / 60 % 60);
    }
}
