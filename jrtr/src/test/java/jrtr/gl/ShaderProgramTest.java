package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import jrtr.GraphicsException;
import jrtr.ShaderSource;
import org.joml.Matrix3f;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector4f;
import org.junit.jupiter.api.Test;

class ShaderProgramTest extends InARendering {
    private float[] pixel(ShaderProgram program) {
        return rendering.drawn(program, 1, 1, Map.of());
    }

    @Test
    void aCompileErrorInAnIncludeHasItsFileLineAndText() {
        ShaderSource broken = Rendering.library(Map.of(
                        "root.frag.glsl", "#version 330 core\n#include \"lens.glsl\"\nvoid main() {}\n",
                        "lens.glsl", "// a lens\nfloat focus() {\n    return distanze;\n}\n"))
                .load("root.frag.glsl", Map.of("TERMS", "37", "WIDTH", "3"));

        assertThatThrownBy(() -> rendering.context.createFullScreenProgram(broken))
                .isInstanceOf(GraphicsException.class)
                .hasMessageStartingWith("lens.glsl:3: ")
                .hasMessageContainingAll("distanze", "`return distanze;`")
                .hasMessageEndingWith("]")
                .hasMessageNotContaining("\n");
        // The driver's own report of the failure must not be mistaken for a later call's.
        rendering.context.finish();
    }

    @Test
    void aLinkErrorNamesBothStages() {
        ShaderSource fragment =
                Rendering.fragment("float missing();\nout vec4 c;\nvoid main() { c = vec4(missing()); }\n");

        assertRefused(
                () -> rendering.context.createFullScreenProgram(fragment),
                "linking jrtr/fullscreen.vert.glsl with test.frag.glsl",
                "missing");
        rendering.context.finish();
    }

    @Test
    void everyTypeOfUniformArrives() {
        ShaderProgram program = rendering.program("""
                uniform float f; uniform int i;
                uniform vec2 v2; uniform vec3 v3; uniform vec4 v4;
                uniform mat3 m3; uniform mat4 m4;
                """, """
                vec4(f + float(i), v2.x + 10.0 * v2.y,
                     (m3 * v3).y, (m4 * v4).w)""");
        program.set("f", 0.25f);
        program.set("i", -3);
        program.set("v2", 1f, 2f);
        Matrix3f m3 = new Matrix3f(1, 2, 3, 4, 5, 6, 7, 8, 9);
        Vector3f v3 = new Vector3f(1, -1, 2);
        program.set("m3", m3);
        program.set("v3", v3);
        Matrix4f m4 = new Matrix4f(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
        Vector4f v4 = new Vector4f(1, 2, -1, 3);
        program.set("m4", m4);
        program.set("v4", new float[] {v4.x, v4.y, v4.z, v4.w});

        // All values are small multiples of 1/4, exact in float.
        assertThat(pixel(program))
                .containsExactly(-2.75f, 21, m3.transform(new Vector3f(v3)).y, m4.transform(new Vector4f(v4)).w);
    }

    @Test
    void anUnknownUniformIsAnErrorThatListsTheOthers() {
        ShaderProgram program = rendering.program("uniform float gain; uniform vec3 light;", "vec4(light, gain)");

        assertRefused(() -> program.set("gian", 1f), "no uniform 'gian'", "float gain, vec3 light");
    }

    @Test
    void aUniformThatIsDeclaredButOptimisedAwayIsIgnored() {
        ShaderProgram program = rendering.program("uniform float unused; uniform float used;", "vec4(used)");

        program.set("unused", 3f);
        program.set("used", 2f);

        assertThat(program.isActive("unused")).isFalse();
        assertThat(pixel(program)).containsOnly(2);
    }

    @Test
    void aValueOfTheWrongTypeIsAnError() {
        ShaderProgram program =
                rendering.program("uniform float gain; uniform sampler2D table;", "gain * texture(table, vec2(0))");

        assertRefused(() -> program.set("gain", 1), "float gain cannot be set to integers");
        assertRefused(() -> program.set("table", 0), "bind a texture");
    }

    @Test
    void samplersOfOtherKindsAreRefused() {
        assertRefused(() -> rendering.program("uniform sampler3D t;", "texture(t, vec3(0))"), "t is not supported");
        assertRefused(() -> rendering.program("uniform sampler2D t[2];", "texture(t[1], vec2(0))"), "not supported");
    }
}
