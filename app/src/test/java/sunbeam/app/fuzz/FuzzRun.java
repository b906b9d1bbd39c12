package sunbeam.app.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/**
 * Runs Jazzer on one reader ({@code ./sunbeam test -Dtest=FuzzRun -Dsunbeam.fuzz.reader=READER}), guided by the coverage of the readers, in a process of the
 * budget's memory. Not among the tests. Jazzer's integration with JUnit is made for JUnit 5; its driver needs no JUnit.
 */
final class FuzzRun {
    private static final Path KEPT = Path.of("src/test/resources/sunbeam/app/fuzz");

    /** For the start, the last input, which may take a minute, and the figures at the end. */
    private static final int PATIENCE_SECONDS = 300;

    @Test
    void run() throws Exception {
        assumeTrue(System.getProperty(FuzzTarget.READER) != null, "skipped: needs -Dsunbeam.fuzz.reader=READER");
        FuzzedReader reader = FuzzedReader.of(System.getProperty(FuzzTarget.READER));
        double minutes = Double.parseDouble(System.getProperty("sunbeam.fuzz.minutes", "1"));
        Path work = Path.of("target", "fuzz", reader.label());
        Path corpus = Files.createDirectories(work.resolve("corpus"));
        Path findings = Files.createDirectories(work.resolve("findings"));
        int number = 0;
        for (byte[] seed : reader.seeds()) {
            Files.write(corpus.resolve("seed-" + number++), seed);
        }
        Process process = FuzzTarget.java(command(reader, minutes, corpus, findings))
                .inheritIO()
                .start();
        boolean ended;
        try {
            ended = process.waitFor(Math.round(60 * minutes) + PATIENCE_SECONDS, TimeUnit.SECONDS);
        } finally {
            process.destroyForcibly();
        }
        assertThat(findings)
                .as("findings, to be kept in %s", KEPT.resolve(reader.corpus()))
                .isEmptyDirectory();
        assertThat(ended).as("the run ended by itself").isTrue();
        assertThat(process.waitFor()).isZero();
    }

    private static String[] command(FuzzedReader reader, double minutes, Path corpus, Path findings) {
        List<String> command = new ArrayList<>(List.of(
                "-D" + FuzzTarget.READER + "=" + reader.label(),
                "com.code_intelligence.jazzer.Jazzer",
                "--target_class=" + FuzzTarget.class.getName(),
                "--instrumentation_includes=sunbeam.**:de.siegmar.**:io.jhdf.**:com.sun.imageio.**",
                "--keep_going=10",
                "-artifact_prefix=" + findings + "/",
                "-max_total_time=" + Math.round(60 * minutes),
                "-max_len=20000",
                "-print_final_stats=1",
                // Of the clock, for inputs that wait; the budget of the processor's time is asserted.
                "-timeout=600",
                "-report_slow_units=3600",
                corpus.toString()));
        Path kept = KEPT.resolve(reader.corpus());
        if (Files.isDirectory(kept)) {
            command.add(kept.toString());
        }
        return command.toArray(String[]::new);
    }
}
