package sunbeam.app.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.failure.Failure;

/** Mutations start from the seeds: those of a refused seed would test refusals only. */
class SeedsTest {
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
