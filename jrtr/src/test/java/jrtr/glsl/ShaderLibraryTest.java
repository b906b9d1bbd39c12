package jrtr.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;

class ShaderLibraryTest {

    @Test
    void findsFilesOnTheClassPath() {
        ShaderLibrary library = ShaderLibrary.ofClassPath(getClass().getClassLoader(), "jrtr/shaders");

        assertThat(library.text("fullscreen.vert.glsl"))
                .hasValueSatisfying(text -> assertThat(text).startsWith("#version 330 core"));
        assertThat(library.text("gone.glsl")).isEmpty();
    }

    @Test
    void anotherLibraryFillsTheGaps() {
        ShaderLibrary first = ShaderTexts.of(Map.of("a", "first a"));
        ShaderLibrary second = ShaderTexts.of(Map.of("a", "second a", "b", "second b"));

        ShaderLibrary both = first.orElse(second);

        assertThat(both.text("a")).hasValue("first a");
        assertThat(both.text("b")).hasValue("second b");
        assertThat(both.text("c")).isEmpty();
    }
}
