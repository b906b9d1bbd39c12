package jrtr;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class VocabularyTest {

    @Test
    void onlyGlNamesJogl() throws IOException, URISyntaxException {
        Path classes =
                Path.of(Tile.class.getResource("/jrtr/Tile.class").toURI()).getParent();
        try (Stream<Path> files = Files.walk(classes)) {
            List<Path> outside = files.filter(file -> file.toString().endsWith(".class"))
                    .filter(file -> !file.startsWith(classes.resolve("gl")))
                    .toList();
            assertThat(outside).isNotEmpty();
            for (Path file : outside) {
                // Names stand in a class file as they are.
                String content = Files.readString(file, StandardCharsets.ISO_8859_1);
                assertThat(content.contains("com/jogamp/")).as(file.toString()).isFalse();
            }
        }
    }
}
