package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import org.junit.jupiter.api.Test;

/** Interrupts and resumes the inspection of a folder of scans. */
class CollectionInterruptionTest extends InWorkplace {
    private static final int SCANS = 40;

    @Test
    void keepsWhatIsFinishedAndResumeInspectsTheOthers() throws Exception {
        Path scans = Files.createDirectory(workplace.resolve("scans"));
        for (int i = 0; i < SCANS; i++) {
            Images.gray(scans.resolve("scan" + (10 + i) + ".png"), 64, 64, (column, row) -> column % 8 < 4 ? 0 : 200);
        }
        Path reports = workplace.resolve("report/reports.jsonl");
        String[] command = {
            "inspect", "scans", "--width", "16um", "--max-height", "100nm", "--output", "report", "--resume"
        };

        try (RunningSunbeam running = workplace.command(command).start()) {
            long deadline = System.nanoTime() + Duration.ofMinutes(2).toNanos();
            while (!Files.exists(reports)) {
                assertThat(System.nanoTime()).as("time until there is a report").isLessThan(deadline);
                Thread.sleep(10);
            }
            running.signal("INT");
            SunbeamResult result = running.end(Duration.ofSeconds(30));
            assertThat(result.exitCode()).as("%s", result).isEqualTo(130);
            assertThat(result.stdout()).isEmpty();
            assertThat(result.complaints()).hasLineCount(1).contains("add --resume");
        }

        assertThat(Files.readAllLines(reports)).hasSizeBetween(1, SCANS - 1);
        assertThat(workplace.resolve("report/table.csv")).doesNotExist();
        Path first = workplace.resolve("report/surfaces/scan10.png");
        FileTime drawn = Files.getLastModifiedTime(first);
        SunbeamResult resumed = workplace.command(command).run();
        assertThat(resumed.exitCode()).as("%s", resumed).isZero();
        assertThat(Files.readAllLines(reports)).hasSize(SCANS);
        assertThat(Files.readAllLines(workplace.resolve("report/table.csv"))).hasSize(SCANS + 1);
        assertThat(Files.getLastModifiedTime(first))
                .as("what is finished stays")
                .isEqualTo(drawn);
    }
}
