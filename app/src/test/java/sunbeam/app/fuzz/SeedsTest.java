package sunbeam.app.fuzz;

import static org.assertj.core.api.Assertions.assertThatCode;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Mutations of what is refused try nothing but refusals. */
class SeedsTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnumSource(FuzzedReader.class)
    void everySeedIsRead(FuzzedReader reader) throws Exception {
        for (byte[] seed : reader.seeds()) {
            Path file = Files.write(folder.resolve(reader.fileName()), seed);
            assertThatCode(() -> reader.read(file)).doesNotThrowAnyException();
        }
    }
}
