package jrtr.glsl;

import static jrtr.gl.InARendering.assertRefused;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import jrtr.GraphicsException;
import jrtr.ShaderSource;
import jrtr.gl.Rendering;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Includes, messages about the lines that they bring, and uniforms that are passed flat. */
class IncludeExpansionTest {
    private static final String VERSION = "#version 330 core\n";

    private static ShaderSource load(Map<String, String> files) {
        return Rendering.library(files).load("root.glsl");
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
    void commentsAreRemoved() {
        assertThat(load(Map.of("root.glsl", VERSION + "x // \u03bb\u00b2\r\ny/* a\n b */z\r\n"))
                        .text())
                .isEqualTo(VERSION + "x\ny\nz\n");
    }

    @Test
    void aCycleEndsAtTheFileThatIsIncludedAlready() {
        ShaderSource source = load(
                Map.of("root.glsl", VERSION + "#include \"a.glsl\"\nend\n", "a.glsl", "a\n#include \"root.glsl\"\n"));
        assertThat(source.text()).isEqualTo(VERSION + "a\n\nend\n");
    }

    @Test
    void definesFollowTheVersionSortedByName() {
        ShaderSource source = Rendering.library(Map.of("root.glsl", "// first\n" + VERSION + "code\n"))
                .load("root.glsl", Map.of("TERMS", "37", "FLAG", "", "RADIUS", "(2.5)"));

        assertThat(source.text())
                .isEqualTo("\n#version 330 core\n#define FLAG\n#define RADIUS (2.5)\n#define TERMS 37\ncode\n");
        assertThat(source.origins().get(3).file()).isEqualTo("<defines>");
        assertThat(source.origins().get(5)).isEqualTo(new ShaderSource.Line("root.glsl", 3, "code"));
    }

    @Test
    void aMissingFileIsNamedWithItsIncluderAndLine() {
        assertThatThrownBy(() -> load(Map.of(
                        "root.glsl", VERSION + "#include \"a.glsl\"\n", "a.glsl", "x\n#include \"gone.glsl\"\n")))
                .isInstanceOf(GraphicsException.class)
                .hasMessageStartingWith("a.glsl:2: included file gone.glsl is missing");
        assertRefused(() -> load(Map.of()), "root.glsl is missing");
    }

    @Test
    void aDefineInBracesChoosesTheFile() {
        ShaderLibrary library = Rendering.library(Map.of(
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
    }

    /** Expanded line 4 is line 2 of lens.glsl. */
    private final ShaderSource source = Rendering.library(Map.of(
                    "root.glsl", "#version 330 core\nfloat a;\n#include \"lens.glsl\"\n",
                    "lens.glsl", "float b;\n    float c = foo; // why\n"))
            .load("root.glsl");

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "0:4(13): error: `foo' undeclared | lens.glsl:2: `foo' undeclared: `float c = foo; // why` [doing]",
                "0:4(1): preprocessor error: syntax error | lens.glsl:2: syntax error: `float c = foo; // why` [doing]",
                "0(4) : error C1503: undefined | lens.glsl:2: C1503: undefined: `float c = foo; // why` [doing]",
                "0(4) : fatal error C9999: gone | lens.glsl:2: C9999: gone: `float c = foo; // why` [doing]",
                "ERROR: 0:4: 'foo' : undeclared | lens.glsl:2: 'foo' : undeclared: `float c = foo; // why` [doing]",
                // A line past the end is the last one.
                "0:99(1): error: end of file | lens.glsl:2: end of file: `float c = foo; // why` [doing]",
                "0:99999999999(1): error: end | lens.glsl:2: end: `float c = foo; // why` [doing]",
                // Messages without a line count only if none has a line; warnings do not count.
                "error: no main | root.glsl: error: no main [doing]",
                "Fragment info;0(2) : error C1: x | root.glsl:2: C1: x: `float a;` [doing]",
                "0:4(3): warning: unused | root.glsl: the driver failed without a reason [doing]",
                "0:2(1): warning: odd;0:2(3): error: a;0:4(1): error: b | root.glsl:2: a: `float a;` [doing, and 1 more]"
            })
    void theMessageOfEveryDriverNamesTheAuthorsLine(String log, String message) {
        assertThat(source.failure("doing", log.replace(";", "\n") + "\n\0")).hasMessage(message);
    }

    private static final ShaderSource VERTEX =
            sourceOf("a.vert", "#version 330 core", "void main() {", "    x();", "}");

    private static ShaderSource sourceOf(String name, String... lines) {
        List<ShaderSource.Line> origins = IntStream.range(0, lines.length)
                .mapToObj(i -> new ShaderSource.Line(name, i + 1, lines[i]))
                .toList();
        return new ShaderSource(name, String.join("\n", lines) + "\n", origins);
    }

    @Test
    void uniformsBecomeFlatInputs() {
        FlatUniforms flat = FlatUniforms.of(
                VERTEX,
                sourceOf(
                        "a.frag",
                        "uniform vec3 light = vec3(1.0, 0.0, 0.0);",
                        "uniform int count;",
                        "main(light, lights)"),
                60);

        assertThat(flat.fragment().text()).isEqualTo("""
                        flat in vec3 light_perDraw;
                        flat in int count_perDraw;
                        main(light_perDraw, lights)
                        """);
        assertThat(flat.vertex().text()).isEqualTo("""
                        #version 330 core
                        uniform vec3 light = vec3(1.0, 0.0, 0.0); flat out vec3 light_perDraw; \
                        uniform int count; flat out int count_perDraw; \
                        void main() {light_perDraw = light; count_perDraw = count;\s
                            x();
                        }
                        """);
    }

    @Test
    void messagesNameTheLinesThatWereWritten() {
        FlatUniforms flat = FlatUniforms.of(VERTEX, sourceOf("a.frag", "uniform float x;", "wrong"), 60);

        assertThat(flat.fragment().origins().stream().map(ShaderSource.Line::number))
                .containsExactly(1, 2);
        assertThat(flat.vertex().origins()).isEqualTo(VERTEX.origins());
    }

    @Test
    void samplersArraysAndUniformsBeyondTheLimitAreNotMoved() {
        String[] lines = {"uniform sampler2D s;", "uniform float a[3];", "uniform mat4 m;", "in vec2 uniform_x;"};
        FlatUniforms flat = FlatUniforms.of(VERTEX, sourceOf("a.frag", lines), 15);

        assertThat(flat.fragment().text().lines()).containsExactly(lines);
        assertThat(flat.vertex().text()).isEqualTo(VERTEX.text());
    }

    @Test
    void aUniformDeclaredInBothBranchesIsPassedOnce() {
        FlatUniforms flat = FlatUniforms.of(
                VERTEX, sourceOf("a.frag", "#if A", "uniform float x;", "#else", "uniform float x;", "#endif"), 60);

        assertThat(flat.fragment().text().lines().filter(line -> line.startsWith("flat in")))
                .hasSize(2);
        assertThat(flat.vertex().text()).containsOnlyOnce("flat out float x_perDraw;");
    }
}
