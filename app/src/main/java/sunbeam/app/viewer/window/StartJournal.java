package sunbeam.app.viewer.window;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.precompute.text.Text;

/** Times of the stages of the viewer's start, in seconds from the start of the process. Thread-safe. */
public final class StartJournal {
    /** Stages of a start, with their names in reports. */
    public enum Stage {
        COMMAND("scene read"),
        WINDOW("window"),
        LOADED("patch, texture and plan"),
        CONTEXT("OpenGL"),
        BODY("body"),
        FIRST("first picture"),
        FINAL("final picture");

        private final String words;

        Stage(String words) {
            this.words = words;
        }
    }

    private final Map<Stage, Double> seconds = new LinkedHashMap<>();
    private final Instant start = ProcessHandle.current().info().startInstant().orElseGet(Instant::now);

    public synchronized void reached(Stage stage) {
        seconds.computeIfAbsent(
                stage, first -> Duration.between(start, Instant.now()).toMillis() * 1e-3);
    }

    synchronized boolean has(Stage stage) {
        return seconds.containsKey(stage);
    }

    public synchronized String report() {
        StringBuilder line = new StringBuilder("since the process began:");
        String between = " ";
        for (Map.Entry<Stage, Double> entry : seconds.entrySet()) {
            line.append(Text.format("%s%s %.1f s", between, entry.getKey().words, entry.getValue()));
            between = ", ";
        }
        return line.toString();
    }
}
