package jrtr.glsl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import jrtr.GraphicsException;
import jrtr.ShaderSource;
import org.junit.jupiter.api.Test;

class IncludeExpansionTest {
    private static final String VERSION = "#version 330 core\n";

    private static ShaderSource load(Map<String, String> files) {
        return ShaderTexts.of(files).load("root.glsl");
    }

    @Test
    void nestedIncludesAreExpandedInPlace() {
        ShaderSource source = load(Map.of(
                "root.glsl", VERSION + "before\n#include \"a.glsl\"\nafter\n",
                "a.glsl", "a1\n  #  include \"sub/b.glsl\"\na3",
                "sub/b.glsl", "b1\n"));

        assertThat(source.text()).isEqualTo(VERSION + "before\na1\nb1\na3\nafter\n");
        assertThat(source.origins())
                .containsExactly(
                        new ShaderSource.Line("root.glsl", 1, "#version 330 core"),
                        new ShaderSource.Line("root.glsl", 2, "before"),
                        new ShaderSource.Line("a.glsl", 1, "a1"),
                        new ShaderSource.Line("sub/b.glsl", 1, "b1"),
                        new ShaderSource.Line("a.glsl", 3, "a3"),
                        new ShaderSource.Line("root.glsl", 4, "after"));
    }

    @Test
    void aFileIsIncludedOnce() {
        ShaderSource source = load(Map.of(
                "root.glsl", VERSION + "#include \"a.glsl\"\n#include \"b.glsl\"\n#include \"a.glsl\"\nend\n",
                "a.glsl", "a\n",
                "b.glsl", "#include \"a.glsl\"\nb\n"));

        assertThat(source.text().lines().filter(line -> !line.isEmpty()))
                .containsExactly("#version 330 core", "a", "b", "end");
    }

    @Test
    void definesFollowTheVersionSortedByName() {
        ShaderSource source = ShaderTexts.of(Map.of("root.glsl", "// first\n" + VERSION + "code\n"))
                .load("root.glsl", Map.of("TERMS", "37", "FLAG", "", "RADIUS", "(2.5)"));

        assertThat(source.text())
                .isEqualTo("\n#version 330 core\n#define FLAG\n#define RADIUS (2.5)\n#define TERMS 37\ncode\n");
        assertThat(source.origins().get(3).file()).isEqualTo("<defines>");
        assertThat(source.origins().get(5)).isEqualTo(new ShaderSource.Line("root.glsl", 3, "code"));
    }

    @Test
    void commentsMayHoldAnyCharacterButCodeOnlyAscii() {
        assertThat(load(Map.of("root.glsl", VERSION + "x // λ²\r\ny\r\n")).text())
                .isEqualTo(VERSION + "x\ny\n");
        assertThatThrownBy(() -> load(Map.of("root.glsl", VERSION + "float λ;\n")))
                .isInstanceOf(GraphicsException.class)
                .hasMessageStartingWith("root.glsl:2: ");
    }

    @Test
    void cyclesAreNamedWithTheirPath() {
        assertThatThrownBy(() -> load(Map.of(
                        "root.glsl", VERSION + "#include \"a.glsl\"\n",
                        "a.glsl", "\n#include \"b.glsl\"\n",
                        "b.glsl", "#include \"a.glsl\"\n")))
                .isInstanceOf(GraphicsException.class)
                .hasMessageStartingWith("b.glsl:1: cycle of includes: root.glsl -> a.glsl -> b.glsl -> a.glsl");
    }

    @Test
    void aMissingFileIsNamedWithItsIncluderAndLine() {
        assertThatThrownBy(() -> load(Map.of(
                        "root.glsl", VERSION + "#include \"a.glsl\"\n", "a.glsl", "x\n#include \"gone.glsl\"\n")))
                .isInstanceOf(GraphicsException.class)
                .hasMessageStartingWith("a.glsl:2: included file gone.glsl is missing");
        assertThatThrownBy(() -> load(Map.of()))
                .isInstanceOf(GraphicsException.class)
                .hasMessageContaining("root.glsl is missing");
    }

    @Test
    void theVersionStandsInTheRootFileBeforeAllCodeAndOnce() {
        assertThatThrownBy(() -> load(Map.of("root.glsl", "x\n" + VERSION))).hasMessageStartingWith("root.glsl:1: ");
        assertThatThrownBy(() -> load(Map.of("root.glsl", "\n// nothing\n"))).hasMessageContaining("#version");
        assertThatThrownBy(() -> load(Map.of("root.glsl", VERSION + VERSION))).hasMessageStartingWith("root.glsl:2: ");
        assertThatThrownBy(() -> load(Map.of("root.glsl", VERSION + "#include \"a.glsl\"\n", "a.glsl", "\n" + VERSION)))
                .hasMessageStartingWith("a.glsl:2: #version belongs in the root file root.glsl");
    }

    @Test
    void aDefineInBracesChoosesTheFile() {
        ShaderLibrary library = ShaderTexts.of(Map.of(
                "root.glsl", VERSION + "#include \"shape/{SHAPE}_{SIDES}.glsl\"\n",
                "shape/prism_3.glsl", "three\n",
                "shape/prism_4.glsl", "four\n"));

        assertThat(library.load("root.glsl", Map.of("SHAPE", "prism", "SIDES", "4"))
                        .text())
                .endsWith("four\n")
                .doesNotContain("three");
        assertThatThrownBy(() -> library.load("root.glsl", Map.of("SHAPE", "prism")))
                .isInstanceOf(GraphicsException.class)
                .hasMessageStartingWith("root.glsl:2: #include uses the define SIDES, which is not set");
        assertThatThrownBy(() -> library.load("root.glsl", Map.of("SHAPE", "prism", "SIDES", "5")))
                .hasMessageStartingWith("root.glsl:2: included file shape/prism_5.glsl is missing");
        assertThatThrownBy(() -> library.load("root.glsl", Map.of("SHAPE", "../prism", "SIDES", "4")))
                .hasMessageStartingWith("root.glsl:2: #include \"shape/../prism_4.glsl\"");
    }
}
