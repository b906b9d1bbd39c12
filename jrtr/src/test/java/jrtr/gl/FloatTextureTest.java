package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.FloatBuffer;
import java.nio.ShortBuffer;
import java.util.Map;
import jrtr.ContextInfo;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Test;

class FloatTextureTest extends InARendering {
    private static final String FETCH_TOP_DOWN = "texelFetch(t, ivec2(gl_FragCoord.xy), 0)";

    private FloatTexture texture(FloatTexture.Spec spec, float... texels) {
        FloatTexture texture = rendering.context.createFloatTexture("table", spec);
        texture.upload(texels);
        return texture;
    }

    @Test
    void everyBitOfNormalNumbersInfinitiesAndZerosSurvives() {
        float[] values = {
            0f,
            -0f,
            1f,
            -1f,
            Float.MAX_VALUE,
            -Float.MAX_VALUE,
            Float.MIN_NORMAL,
            -Float.MIN_NORMAL,
            Float.POSITIVE_INFINITY,
            Float.NEGATIVE_INFINITY,
            1 / 3f,
            1e-30f,
            1e30f,
            16777215f,
            0.1f,
            3.4e-38f
        };
        ShaderProgram program = rendering.program("uniform sampler2D t;", FETCH_TOP_DOWN);
        FloatTexture texture = texture(FloatTexture.Spec.flat(4, 1, FloatTexture.Format.RGBA32F), values);

        float[] back = rendering.drawn(program, 4, 1, Map.of("t", texture));

        for (int index = 0; index < values.length; index++) {
            assertThat(Float.floatToRawIntBits(back[index]))
                    .as("%s", values[index])
                    .isEqualTo(Float.floatToRawIntBits(values[index]));
        }
    }

    @Test
    void halvesArriveAsTheyAreAndAreInterpolatedBetween() {
        // 1, 1.5, -2, 65504; 3, 0.5, 2^-14, 2^-24.
        short[] halves = {0x3c00, 0x3e00, (short) 0xc000, 0x7bff, 0x4200, 0x3800, 0x0400, 0x0001};
        FloatTexture.Spec spec = FloatTexture.Spec.array(2, 1, 1, FloatTexture.Format.RGBA16F);
        FloatTexture texture = rendering.context.createFloatTexture("table", spec.with(FloatTexture.Filter.LINEAR));
        texture.uploadLayer(0, ShortBuffer.wrap(halves));
        ShaderProgram exact =
                rendering.program("uniform sampler2DArray t;", "texelFetch(t, ivec3(gl_FragCoord.xy, 0), 0)");
        float[] back = rendering.drawn(exact, 2, 1, Map.of("t", texture));
        assertThat(back).startsWith(1, 1.5f, -2, 65504, 3, 0.5f, 0x1p-14f);
        // Denormals may be flushed to zero.
        assertThat(back[7]).isIn(0x1p-24f, 0f);
        ShaderProgram between =
                rendering.program("uniform sampler2DArray t;", "textureLod(t, vec3(0.5, 0.5, 0.0), 0.0)");
        // Cards weigh with 8 bits at least.
        assertThat(rendering.drawn(between, 1, 1, Map.of("t", texture))[0]).isCloseTo(2, within(1 / 128f));
    }

    @Test
    void theFilterFollowsTheSpecificationAndEdgesAreClamped() {
        ShaderProgram program = rendering.program(
                "uniform sampler2D t;",
                "vec4(texture(t, vec2(0.5, 0.5)).r, texture(t, vec2(1.25, 0.5)).r,"
                        + "texture(t, vec2(0.3, 0.5)).r, texture(t, vec2(0.75, 0.5)).r)");
        FloatTexture.Spec spec = FloatTexture.Spec.flat(2, 1, FloatTexture.Format.R32F);
        FloatTexture linear = texture(spec.with(FloatTexture.Filter.LINEAR), 10, 20);
        FloatTexture nearest = texture(spec, 10, 20);

        float[] interpolated = rendering.drawn(program, 1, 1, Map.of("t", linear));
        float[] stepped = rendering.drawn(program, 1, 1, Map.of("t", nearest));

        // Texel centers at 1/4 and 3/4. Hardware keeps 8 bits of the weight or more: 10 / 256 = 0.04.
        assertThat(interpolated[0]).isCloseTo(15, within(0.04f));
        assertThat(interpolated[1]).isCloseTo(20, within(0.04f));
        assertThat(interpolated[2]).isCloseTo(11, within(0.04f));
        assertThat(interpolated[3]).isCloseTo(20, within(0.04f));
        assertThat(stepped[1]).isEqualTo(20);
        assertThat(stepped[2]).isEqualTo(10);
        assertThat(stepped[3]).isEqualTo(20);
    }

    @Test
    void sizesBeyondTheDriversLimitsAreRefusedWithNeededAndAllowed() {
        ContextInfo.Limits limits = rendering.context.info().limits();
        int side = limits.textureSize() + 1;

        assertThatThrownBy(() -> rendering.context.createFloatTexture(
                        "too wide", FloatTexture.Spec.flat(side, 1, FloatTexture.Format.R32F)))
                .isInstanceOf(GraphicsException.class)
                .hasMessageContainingAll("'too wide' needs " + side + " x 1 texels", "at most " + limits.textureSize());
        assertThatThrownBy(() -> rendering.context.createFloatTexture(
                        "too deep", FloatTexture.Spec.array(1, 1, limits.arrayLayers() + 1, FloatTexture.Format.R32F)))
                .isInstanceOf(GraphicsException.class)
                .hasMessageContainingAll((limits.arrayLayers() + 1) + " layers", "at most " + limits.arrayLayers());
    }

    @Test
    void bindingsThatDoNotFitAreRefused() {
        ShaderProgram program = rendering.program("uniform sampler2D t;", FETCH_TOP_DOWN);
        FloatTexture flat = texture(FloatTexture.Spec.flat(1, 1, FloatTexture.Format.R32F), 1);
        FloatTexture array = texture(FloatTexture.Spec.array(1, 1, 1, FloatTexture.Format.R32F), 1);
        FloatTexture empty = rendering.context.createFloatTexture(
                "empty", FloatTexture.Spec.array(1, 1, 2, FloatTexture.Format.R32F));
        empty.uploadLayer(0, FloatBuffer.wrap(new float[] {1}));

        assertThatThrownBy(() -> rendering.drawn(program, 1, 1, Map.of()))
                .isInstanceOf(GraphicsException.class)
                .hasMessageContaining("no texture is bound to sampler 't'");
        assertThatThrownBy(() -> rendering.drawn(program, 1, 1, Map.of("t", array)))
                .isInstanceOf(GraphicsException.class)
                .hasMessageContainingAll("'table' is an array", "sampler2D t");
        assertThatThrownBy(() -> rendering.drawn(program, 1, 1, Map.of("u", flat)))
                .isInstanceOf(GraphicsException.class)
                .hasMessageContaining("no uniform 'u'");
        assertThatThrownBy(() -> rendering.drawn(program, 1, 1, Map.of("t", empty)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("layer 1 was uploaded");
    }
}
