package jrtr.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.ShaderSource;
import org.junit.jupiter.api.Test;

class FlatUniformsTest {
    private static final ShaderSource VERTEX = source("a.vert", "#version 330 core", "void main() {", "    x();", "}");

    private static ShaderSource source(String name, String... lines) {
        List<ShaderSource.Line> origins = IntStream.range(0, lines.length)
                .mapToObj(i -> new ShaderSource.Line(name, i + 1, lines[i]))
                .toList();
        return new ShaderSource(name, String.join("\n", lines) + "\n", origins);
    }

    @Test
    void uniformsBecomeFlatInputsOfTheSameName() {
        FlatUniforms flat = FlatUniforms.of(
                VERTEX,
                source("a.frag", "uniform vec3 light = vec3(1.0, 0.0, 0.0);", "uniform int count;", "main"),
                60);

        assertThat(flat.fragment().text()).isEqualTo("""
                        flat in vec3 light_perDraw;
                        #define light light_perDraw
                        flat in int count_perDraw;
                        #define count count_perDraw
                        main
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
        FlatUniforms flat = FlatUniforms.of(VERTEX, source("a.frag", "uniform float x;", "wrong"), 60);

        assertThat(flat.fragment().origins().stream().map(ShaderSource.Line::number))
                .containsExactly(1, 1, 2);
        assertThat(flat.vertex().origins()).isEqualTo(VERTEX.origins());
    }

    @Test
    void samplersArraysAndUniformsBeyondTheLimitAreNotMoved() {
        String[] lines = {"uniform sampler2D s;", "uniform float a[3];", "uniform mat4 m;", "in vec2 uniform_x;"};
        FlatUniforms flat = FlatUniforms.of(VERTEX, source("a.frag", lines), 15);

        assertThat(flat.fragment().text().lines()).containsExactly(lines);
        assertThat(flat.vertex().text()).isEqualTo(VERTEX.text());
    }

    @Test
    void aUniformDeclaredInBothBranchesIsPassedOnce() {
        FlatUniforms flat = FlatUniforms.of(
                VERTEX, source("a.frag", "#if A", "uniform float x;", "#else", "uniform float x;", "#endif"), 60);

        assertThat(flat.fragment().text().lines().filter(line -> line.startsWith("flat in")))
                .hasSize(2);
        assertThat(flat.vertex().text()).containsOnlyOnce("flat out float x_perDraw;");
    }
}
