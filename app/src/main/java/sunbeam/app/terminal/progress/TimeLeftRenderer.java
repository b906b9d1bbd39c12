package sunbeam.app.terminal.progress;

import java.time.Duration;
import java.util.Locale;
import me.tongfei.progressbar.ProgressBarRenderer;
import me.tongfei.progressbar.ProgressState;

/**
 * {@code rendering [=====>     ]  45 %, 12 s left}, in ASCII, which every terminal shows.
 *
 * @param withBar else {@code rendering: 45 %, 12 s left}
 */
record TimeLeftRenderer(boolean withBar) implements ProgressBarRenderer {
    private static final int FEWEST_BAR = 5;
    // What begins slowly would end in hours: nothing is said of so little, for so long.
    private static final double TOO_LITTLE = 0.01;
    private static final Duration TOO_EARLY = Duration.ofSeconds(10);

    @Override
    public String render(ProgressState state, int maxLength) {
        double done = state.getMax() == 0 ? 1 : Math.min(1, state.getCurrent() / (double) state.getMax());
        return withBar
                ? render(state.getTaskName(), done, state.getElapsedAfterStart(), maxLength)
                : plain(state.getTaskName(), done, state.getElapsedAfterStart());
    }

    static String render(String label, double done, Duration elapsed, int maxLength) {
        String figures = String.format(Locale.ROOT, " %3.0f %%, %s", percent(done), timeLeft(done, elapsed));
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

    static String plain(String label, double done, Duration elapsed) {
        return String.format(Locale.ROOT, "%s: %.0f %%, %s", label, percent(done), timeLeft(done, elapsed));
    }

    private static double percent(double done) {
        return Math.floor(100 * done);
    }

    /** Assumes that the rest goes as fast as what is done. */
    private static String timeLeft(double done, Duration elapsed) {
        if (done <= 0 || (done < TOO_LITTLE && elapsed.compareTo(TOO_EARLY) < 0)) {
            return "time left unknown";
        }
        long seconds = Math.round(elapsed.toMillis() / 1000.0 * (1 - done) / done);
        if (seconds < 60) {
            return seconds + " s left";
        }
        if (seconds < 3600) {
            return String.format(Locale.ROOT, "%d:%02d min left", seconds / 60, seconds % 60);
        }
        return String.format(Locale.ROOT, "%d:%02d h left", seconds / 3600, seconds / 60 % 60);
    }
}
