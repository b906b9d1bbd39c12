package jrtr.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ShaderLibraryTest {

    @Test
    void findsFilesOnTheClassPath() {
        ShaderLibrary library = ShaderLibrary.ofClassPath(getClass().getClassLoader(), "jrtr/shaders");

        assertThat(library.text("fullscreen.vert.glsl"))
                .hasValueSatisfying(text -> assertThat(text).startsWith("#version 330 core"));
        assertThat(library.text("gone.glsl")).isEmpty();
    }

    @Test
    void findsFilesInAFolder(@TempDir Path folder) throws IOException {
        Files.createDirectories(folder.resolve("sub"));
        Files.writeString(folder.resolve("sub/a.glsl"), "float λ; // text as it is");

        ShaderLibrary library = ShaderLibrary.ofFolder(folder);

        assertThat(library.text("sub/a.glsl")).hasValue("float λ; // text as it is");
        assertThat(library.text("sub")).isEmpty();
        assertThat(library.text("b.glsl")).isEmpty();
    }

    @Test
    void anotherLibraryFillsTheGaps() {
        ShaderLibrary first = ShaderLibrary.ofMap(Map.of("a", "first a"));
        ShaderLibrary second = ShaderLibrary.ofMap(Map.of("a", "second a", "b", "second b"));

        ShaderLibrary both = first.orElse(second);

        assertThat(both.text("a")).hasValue("first a");
        assertThat(both.text("b")).hasValue("second b");
        assertThat(both.text("c")).isEmpty();
    }
}
