package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class FileGroupTest {
    private static final List<String> ENDINGS = List.of(".png", ".csv", ".json");

    @TempDir
    private Path folder;

    private static Map<String, AtomicFile.StreamContent> contents(String text) {
        Map<String, AtomicFile.StreamContent> contents = new LinkedHashMap<>();
        ENDINGS.forEach(ending -> contents.put(ending, stream -> stream.write(text.getBytes(StandardCharsets.UTF_8))));
        return contents;
    }

    private FileGroup group(Overwrite overwrite) {
        return new FileGroup(folder.resolve("blaze"), ENDINGS, overwrite);
    }

    private List<String> names() {
        return new ArrayList<>(new TreeSet<>(List.of(folder.toFile().list())));
    }

    @Test
    void allFilesHaveOneNumberAlsoWhereOneNameAloneIsTaken() throws IOException {
        Files.writeString(folder.resolve("blaze.csv"), "somebody's");
        Files.writeString(folder.resolve("blaze-2.json"), "somebody's");

        List<Path> places = group(Overwrite.NUMBER).write(contents("new"));

        assertThat(places)
                .extracting(place -> place.getFileName().toString())
                .containsExactly("blaze-3.png", "blaze-3.csv", "blaze-3.json");
        assertThat(names()).containsExactly("blaze-2.json", "blaze-3.csv", "blaze-3.json", "blaze-3.png", "blaze.csv");
        assertThat(folder.resolve("blaze.csv")).hasContent("somebody's");
    }

    @Test
    void noFileAppearsIfOneMayNotBeReplaced() throws IOException {
        FileGroup group = group(Overwrite.REFUSE);
        Map<String, AtomicFile.StreamContent> contents = contents("new");
        // Another program creates a file while the last one is written.
        contents.put(".json", stream -> Files.writeString(folder.resolve("blaze.csv"), "somebody's"));

        assertThatThrownBy(() -> group.write(contents))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("blaze.csv: it exists; add --force");
        assertThat(names()).containsExactly("blaze.csv");
        assertThat(folder.resolve("blaze.csv")).hasContent("somebody's");
    }

    @Test
    void noFileAppearsIfTheContentOfOneFails() {
        Map<String, AtomicFile.StreamContent> contents = contents("new");
        contents.put(".json", stream -> {
            throw new IOException("No space left on device");
        });

        assertThatThrownBy(() -> group(Overwrite.NUMBER).write(contents)).hasMessageContaining("free some space");
        assertThat(names()).isEmpty();
    }
}
