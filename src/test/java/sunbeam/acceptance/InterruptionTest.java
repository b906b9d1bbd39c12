package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Ends the real program while it works. That {@code --resume} goes on with what is left is tested command by command. */
class InterruptionTest extends InWorkplace {
    // Drawing takes hours.
    private static final String MAP = "brdf-map --patch blaze --size 8192 --output a.png";

    private SunbeamResult interrupt(String commandLine, Callable<Boolean> hasBegun) throws Exception {
        try (RunningSunbeam running = workplace.command(commandLine).start()) {
            RunningSunbeam.await("the first result", hasBegun);
            running.signal("INT");
            SunbeamResult result = running.end(Duration.ofSeconds(30)).ended(Complaint.INTERRUPTED);
            assertThat(result.stdout()).isEmpty();
            return result;
        }
    }

    /** True a second after the tables are in the cache, which are written before the drawing starts. */
    private boolean isDrawing() throws Exception {
        boolean hasTable =
                workplace.tables().stream().anyMatch(table -> table.toString().endsWith(".tables"));
        Thread.sleep(hasTable ? 1000 : 0);
        return hasTable;
    }

    @Test
    void aMapLeavesNothingAndSaysNothing() throws Exception {
        SunbeamResult result = interrupt(MAP + " --linear a.npy", this::isDrawing);

        assertThat(result.stderr()).startsWith("plan: ").hasLineCount(1);
        assertThat(workplace.files()).isEmpty();
        assertThat(workplace.tables()).allMatch(table -> table.toString().endsWith(".tables"));
    }

    /** Xlib would crash Java at the next call, after hours of drawing for nothing. */
    @Test
    void aScreenThatEndsIsOneLine() throws Exception {
        try (RunningSunbeam running = workplace.command(MAP).without("DISPLAY").start()) {
            RunningSunbeam.await("the drawing", this::isDrawing);
            ProcessHandle screen = running.process()
                    .descendants()
                    .filter(process -> process.info().command().orElse("").endsWith("/Xvfb"))
                    .findFirst()
                    .orElseThrow();
            assertThat(screen.destroyForcibly()).isTrue();
            SunbeamResult result = running.end(Duration.ofSeconds(60)).ended(Complaint.NO_GRAPHICS);
            assertThat(result.stdout()).isEmpty();
            assertThat(result.stderr().lines().skip(1))
                    .singleElement()
                    .satisfies(line -> assertThat(line)
                            .startsWith("sunbeam: the X server of DISPLAY=:")
                            .contains("has ended"));
        }
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void aFolderOfScansKeepsTheFinishedReports() throws Exception {
        Path scans = Files.createDirectory(workplace.resolve("scans"));
        for (int i = 0; i < 40; i++) {
            Images.gray(scans.resolve("scan" + i + ".png"), 64, 64, (column, row) -> column % 8 < 4 ? 0 : 200);
        }
        Path reports = workplace.resolve("report/reports.jsonl");

        SunbeamResult result =
                interrupt("inspect scans --width 16um --max-height 100nm --output report", () -> Files.exists(reports));

        assertThat(result.complaints()).hasLineCount(1).contains("add --resume");
        assertThat(Files.readAllLines(reports)).hasSizeBetween(1, 39);
        assertThat(workplace.resolve("report/table.csv")).doesNotExist();
    }

    @Test
    @Tag("thorough")
    void anAnimationKeepsTheFinishedFrames() throws Exception {
        // With supersampling a frame takes long enough to be interrupted.
        SunbeamResult result = interrupt(
                "render xenopeltis --size 96x72 --supersample 4 --light-sweep 0:90 --frames 12 --output sweep",
                () -> Files.exists(workplace.resolve("sweep/frame-0001.png")));

        assertThat(result.complaints()).hasLineCount(1).contains("add --resume");
        assertThat(workplace.files()).containsExactly("sweep");
        assertThat(workplace.resolve("sweep").toFile().list())
                .hasSizeBetween(1, 11)
                .allMatch(name -> name.matches("frame-\\d{4}\\.png"));
    }
}
