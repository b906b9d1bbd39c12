package jrtr.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;

class DeclaredUniformsTest {

    @Test
    void findsEveryDeclaratorOfEveryForm() {
        String text = """
                #version 330 core
                #define N 4
                uniform float plain;
                uniform  vec3 a , b[ N ], c = vec3(1, 2, 3), d;
                // uniform float commented;
                uniform
                    sampler2DArray table;
                #if 0
                uniform highp mat4 hidden;
                #endif
                uniform Light light[2];
                float not_uniform; int uniformity;
                """;

        assertThat(DeclaredUniforms.in(ShaderTexts.of(Map.of("x", text)).load("x")))
                .containsExactly("a", "b", "c", "d", "hidden", "light", "plain", "table");
    }
}
