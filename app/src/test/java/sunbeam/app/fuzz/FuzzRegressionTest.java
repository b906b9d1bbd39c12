package sunbeam.app.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.failure.Failure;

/** What fuzzing has found stays mended: all readers, with 512 MB and 5 s for each input, of mutations of seeds that are read. */
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

    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnumSource(FuzzedReader.class)
    void everySeedIsRead(FuzzedReader reader) throws Exception {
        assertThat(reader.seeds()).isNotEmpty();
        for (byte[] seed : reader.seeds()) {
            Path file = Files.write(folder.resolve(reader.fileName()), seed);
            assertThatCode(() -> reader.read(file)).doesNotThrowAnyException();
        }
    }

    @ParameterizedTest
    @EnumSource(FuzzedReader.class)
    void anEmptyFileIsRefused(FuzzedReader reader) throws Exception {
        Path file = Files.write(folder.resolve(reader.fileName()), new byte[0]);
        assertThatThrownBy(() -> reader.read(file))
                .satisfies(refusal -> assertThat(Failure.of(refusal).isBug()).isFalse());
    }
}
