package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Interrupts and resumes an animation. */
@Tag("thorough")
class RenderInterruptionTest extends InWorkplace {
    private static final int FRAMES = 12;
    private static final String SCENE = """
            { "mesh": "sphere", "patch": "blaze", "texture": "dark",
              "camera": { "position": ["0 cm", "-30 cm", "30 cm"], "lookAt": ["0 cm", "0 cm", "0 cm"] },
              "light": { "direction": [0, 0, 1] },
              "plan": { "method": "full", "tolerance": 0.1 },
              "weights": { "diffraction": 1000, "texture": 1 } }
            """;

    @Test
    void keepsTheFinishedFramesAndResumeDrawsTheOthers() throws Exception {
        Files.writeString(workplace.resolve("scene.json"), SCENE);
        Path folder = workplace.resolve("sweep");
        Path first = folder.resolve("frame-0001.png");

        try (RunningSunbeam running = sweep(workplace, FRAMES).start()) {
            await(first);
            running.signal("INT");
            SunbeamResult result = running.end(Duration.ofSeconds(30));
            assertThat(result.exitCode()).as("%s", result).isEqualTo(130);
            assertThat(result.stdout()).isEmpty();
            assertThat(result.complaints()).hasLineCount(1).contains("add --resume");
        }

        List<String> kept = names(folder);
        assertThat(kept).hasSizeBetween(1, FRAMES - 1).allMatch(name -> name.matches("frame-\\d{4}\\.png"));
        assertThat(workplace.files()).containsExactly("scene.json", "sweep");
        FileTime drawn = Files.getLastModifiedTime(first);
        SunbeamResult resumed = sweep(workplace, FRAMES, "--resume").run();
        assertThat(resumed.exitCode()).as("%s", resumed).isZero();
        assertThat(names(folder)).hasSize(FRAMES + 1).contains("animation.gif").containsAll(kept);
        assertThat(Files.getLastModifiedTime(first))
                .as("a finished frame stays")
                .isEqualTo(drawn);
    }

    private static Sunbeam sweep(Workplace workplace, int frames, String... more) {
        // With supersampling a frame takes long enough to be interrupted.
        Stream<String> arguments = Stream.of(
                "render",
                "scene.json",
                "--size",
                "96x72",
                "--supersample",
                "4",
                "--light-sweep",
                "0:90",
                "--frames",
                String.valueOf(frames),
                "--output",
                "sweep");
        return workplace.command(Stream.concat(arguments, Stream.of(more)).toArray(String[]::new));
    }

    private static void await(Path frame) throws Exception {
        long deadline = System.nanoTime() + Duration.ofSeconds(60).toNanos();
        while (!Files.exists(frame)) {
            assertThat(System.nanoTime()).as("time until there is a frame").isLessThan(deadline);
            Thread.sleep(10);
        }
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
