package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class DefaultNameTest {
    @TempDir
    private Path folder;

    private String choose(Overwrite overwrite) {
        return DefaultName.choose(folder, "blaze", "png", overwrite)
                .getFileName()
                .toString();
    }

    @Test
    void takesTheFirstNameThatIsFree() throws IOException {
        assertThat(choose(Overwrite.REFUSE)).isEqualTo("blaze.png");
        Files.createFile(folder.resolve("blaze.png"));
        assertThat(choose(Overwrite.REFUSE)).isEqualTo("blaze-2.png");
        Files.createFile(folder.resolve("blaze-2.png"));
        assertThat(choose(Overwrite.REFUSE)).isEqualTo("blaze-3.png");
    }

    @Test
    void takesThePlainNameWhenForced() throws IOException {
        Files.createFile(folder.resolve("blaze.png"));
        assertThat(choose(Overwrite.REPLACE)).isEqualTo("blaze.png");
    }
}
