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
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        FuzzTarget.HEAP,
                        "-Djava.awt.headless=true",
                        "-Dslf4j.internal.verbosity=ERROR",
                        "-cp",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                        FuzzRegression.class.getName(),
                        kept.toAbsolutePath().toString(),
                        Integer.toString(MUTATIONS))
                .redirectErrorStream(true)
                .start();
        String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(told).isZero();
        assertThat(told).contains("findings: 0");
        told.lines().forEach(line -> reporter.publishEntry("fuzz", line));
    }
}
