package sunbeam.app.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;

/** What fuzzing has found stays mended: all readers, with 512 MB and 5 s for each input. */
final class FuzzRegressionTest {
    private static final int MUTATIONS = 150;

    @Test
    void everyReaderReadsOrRefuses(TestReporter reporter) throws Exception {
        Path kept = Path.of("src/test/resources/sunbeam/app/fuzz");
        Process process = FuzzTarget.java(
                        FuzzRegression.class.getName(), kept.toAbsolutePath().toString(), Integer.toString(MUTATIONS))
                .redirectErrorStream(true)
                .start();
        String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(told).isZero();
        assertThat(told).contains("findings: 0");
        told.lines().forEach(line -> reporter.publishEntry("fuzz", line));
    }
}
