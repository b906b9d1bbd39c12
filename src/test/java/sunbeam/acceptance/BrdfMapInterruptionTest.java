package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Interrupts the drawing of a map. */
class BrdfMapInterruptionTest extends InWorkplace {
    @ParameterizedTest
    @CsvSource({"INT, 130"})
    void leavesNothingAndSaysNothing(String signal, int exitCode) throws Exception {
        Sunbeam hours = workplace.command(
                "brdf-map", "--patch", "blaze", "--size", "8192", "--output", "a.png", "--linear", "a.npy");

        try (RunningSunbeam running = hours.start()) {
            awaitDrawing(workplace);
            running.signal(signal);
            SunbeamResult result = running.end(Duration.ofSeconds(30));

            assertThat(result.exitCode()).as("%s", result).isEqualTo(exitCode);
            assertThat(result.stdout()).isEmpty();
            assertThat(result.stderr()).startsWith("plan: ").hasLineCount(1);
        }
        assertThat(workplace.files()).isEmpty();
        assertThat(workplace.tables()).allMatch(table -> table.toString().endsWith(".tables"));
    }

    /** Xlib would crash Java at the next call, after hours of drawing for nothing. */
    @Test
    void aScreenThatEndsIsOneLine() throws Exception {
        Sunbeam hours = workplace
                .command("brdf-map", "--patch", "blaze", "--size", "8192", "--output", "a.png")
                .without("DISPLAY");

        try (RunningSunbeam running = hours.start()) {
            awaitDrawing(workplace);
            ProcessHandle screen = running.process()
                    .descendants()
                    .filter(process -> process.info().command().orElse("").endsWith("/Xvfb"))
                    .findFirst()
                    .orElseThrow();
            assertThat(screen.destroyForcibly()).isTrue();
            SunbeamResult result = running.end(Duration.ofSeconds(60));

            assertThat(result.exitCode()).as("%s", result).isEqualTo(Complaint.NO_GRAPHICS);
            assertThat(result.stdout()).isEmpty();
            assertThat(result.stderr().lines().skip(1))
                    .singleElement()
                    .satisfies(line -> assertThat(line)
                            .startsWith("sunbeam: the X server of DISPLAY=:")
                            .contains("has ended"));
        }
        assertThat(workplace.files()).isEmpty();
    }

    /** Waits for the tables in the cache, which are written before the drawing starts. The drawing takes hours. */
    private static void awaitDrawing(Workplace workplace) throws Exception {
        long deadline = System.nanoTime() + Duration.ofSeconds(60).toNanos();
        while (workplace.tables().stream().noneMatch(table -> table.toString().endsWith(".tables"))) {
            assertThat(System.nanoTime()).as("time until there is a table").isLessThan(deadline);
            Thread.sleep(50);
        }
        Thread.sleep(1000);
    }
}
