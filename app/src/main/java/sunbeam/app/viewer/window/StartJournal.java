package sunbeam.app.viewer.window;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import sunbeam.precompute.text.Text;

/** Times of the stages of the viewer's start, with the processor time of the process until then. Thread-safe. */
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

    private final Map<Stage, Moment> moments = new LinkedHashMap<>();
    private final Instant start = ProcessHandle.current().info().startInstant().orElseGet(Instant::now);

    private record Moment(Duration elapsed, Duration processor) {}

    public synchronized void reached(Stage stage) {
        moments.computeIfAbsent(
                stage,
                first -> new Moment(
                        Duration.between(start, Instant.now()),
                        ProcessHandle.current().info().totalCpuDuration().orElse(Duration.ZERO)));
    }

    public synchronized String report() {
        return moments.entrySet().stream()
                .map(entry -> Text.format(
                        "%s %.1f s (%.1f)",
                        entry.getKey().words,
                        entry.getValue().elapsed.toMillis() * 1e-3,
                        entry.getValue().processor.toMillis() * 1e-3))
                .collect(Collectors.joining(", ", "since the process began (processor time in brackets): ", ""));
    }
}
