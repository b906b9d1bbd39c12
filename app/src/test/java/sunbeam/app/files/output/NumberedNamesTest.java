package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class NumberedNamesTest {
    @TempDir
    private Path folder;

    private String write(Overwrite overwrite) {
        return AtomicFile.write(folder.resolve("blaze.png"), overwrite, stream -> stream.write(1))
                .getFileName()
                .toString();
    }

    @Test
    void takesTheFirstNameThatIsFree() {
        assertThat(write(Overwrite.NUMBER)).isEqualTo("blaze.png");
        assertThat(write(Overwrite.NUMBER)).isEqualTo("blaze-2.png");
        assertThat(write(Overwrite.NUMBER)).isEqualTo("blaze-3.png");
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("blaze.png", "blaze-2.png", "blaze-3.png");
    }

    @Test
    void takesThePlainNameWhenForced() {
        write(Overwrite.NUMBER);
        assertThat(write(Overwrite.REPLACE)).isEqualTo("blaze.png");
        assertThat(folder).isDirectoryContaining("glob:**blaze.png");
    }

    @Test
    void aLinkThatLeadsNowhereTakesANameToo() throws IOException {
        Files.createSymbolicLink(folder.resolve("blaze.png"), folder.resolve("gone"));
        assertThat(write(Overwrite.NUMBER)).isEqualTo("blaze-2.png");
    }

    @Test
    void aFolderOfSunbeamsChoiceIsItsOwn() throws IOException {
        Path wanted = folder.resolve("v1.2-sweep");
        assertThat(OutputFolder.claim(wanted, false)).isEqualTo(wanted).isEmptyDirectory();
        assertThat(OutputFolder.claim(wanted, false)).isEqualTo(folder.resolve("v1.2-sweep-2"));
        assertThat(OutputFolder.claim(wanted, true)).isEqualTo(wanted);
    }
}
