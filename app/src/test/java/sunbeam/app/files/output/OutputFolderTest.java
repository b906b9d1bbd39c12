package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputFolderTest {
    @TempDir
    private Path folder;

    @Test
    void aFolderIsMadeOrUsedAsItIs() {
        Path wanted = folder.resolve("frames");

        OutputFolder.create(wanted);
        OutputFolder.create(wanted);

        assertThat(wanted).isDirectory();
    }

    @Test
    void theMessageSaysWhatIsInTheWay() throws IOException {
        Path file = Files.writeString(folder.resolve("frames"), "mine");
        Path deep = folder.resolve("no/such/frames");

        assertThatThrownBy(() -> OutputFolder.create(file))
                .isInstanceOf(OutputException.class)
                .hasMessageContainingAll(file.toString(), "a file has this name", "--output");
        assertThatThrownBy(() -> OutputFolder.create(deep))
                .isInstanceOf(OutputException.class)
                .hasMessageContainingAll(deep.toString(), "does not exist", "--output");
    }
}
