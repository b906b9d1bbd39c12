package sunbeam.app.scene.mesh;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.precompute.files.InputException;

/** Reading of a file that a test writes; its first bytes tell the format. */
abstract class MeshReading {
    @TempDir
    Path folder;

    final MeshSource.Loaded read(byte[] content) throws IOException {
        return MeshSource.read(Files.write(folder.resolve("mesh"), content), MeshSource.Unit.M);
    }

    final MeshSource.Loaded read(String content) throws IOException {
        return read(content.getBytes(StandardCharsets.ISO_8859_1));
    }

    final void assertRefused(String content, String... words) {
        assertThatThrownBy(() -> read(content))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(folder.resolve("mesh").toString())
                .hasMessageContainingAll(words)
                .hasMessageNotContaining("\n");
    }
}
