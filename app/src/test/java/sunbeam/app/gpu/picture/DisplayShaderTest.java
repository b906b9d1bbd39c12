package sunbeam.app.gpu.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.ShaderProgram;
import jrtr.glsl.ShaderLibrary;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.gpu.Shaders;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;

/** display.glsl and srgb.glsl against their twins in double precision. */
class DisplayShaderTest extends InAContext {
    // The shader's matrices have seven digits behind the point, its numbers 24 bits.
    private static final double DIGITS = 1e-7;

    /** All chromaticities, also impossible ones, at luminances from black to infinitely bright; some colors without luminance. */
    private static List<float[]> colors() {
        List<float[]> colors = new ArrayList<>();
        for (double luminance : new double[] {1e-7, 0.003, 0.2, 0.5, 0.999, 1.001, 3, 100, 1e4, 1e12, -1e-3}) {
            for (double x = -0.05; x < 0.9; x += 0.05) {
                for (double y = 0.025; y < 1; y += 0.05) {
                    double scale = luminance / y;
                    colors.add(new float[] {(float) (scale * x), (float) luminance, (float) (scale * (1 - x - y)), 1});
                }
            }
        }
        return colors;
    }

    @ParameterizedTest
    @CsvSource({"1, COMPRESS", "0.004, COMPRESS", "217, COMPRESS", "1, CLIP", "217, CLIP"})
    void movingPicturesLookLikeStillOnes(double exposure, Tone tone) {
        String shader = """
                #version 330 core
                #include "include/display.glsl"
                uniform sampler2D xyz;
                layout(location = 0) out vec4 color;
                void main() { color = vec4(displayLight(texelFetch(xyz, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }
                """;
        List<float[]> colors = colors();
        float[] texels = new float[4 * colors.size()];
        for (int i = 0; i < colors.size(); i++) {
            System.arraycopy(colors.get(i), 0, texels, 4 * i, 4);
        }
        ShaderLibrary library = name -> name.equals("test.frag") ? Optional.of(shader) : Optional.empty();
        float[] shown;
        try (FloatTexture texture = context.createFloatTexture(
                        "xyz", FloatTexture.Spec.flat(colors.size(), 1, FloatTexture.Format.RGBA32F));
                ShaderProgram program = context.createFullScreenProgram(
                        library.orElse(Shaders.library()).load("test.frag"));
                FloatTarget target = context.createFloatTarget("test", FloatTarget.Spec.color(colors.size(), 1))) {
            texture.upload(texels);
            program.set("exposure", (float) exposure);
            program.set("toneStart", (float) tone.start());
            context.drawFullScreen(program, Map.of("xyz", texture), target, Tile.whole(colors.size(), 1));
            shown = target.read(0);
        }

        double[] expected = new double[3];
        for (int i = 0; i < colors.size(); i++) {
            new DisplayTransform(exposure, tone).light(colors.get(i), 0, expected);
            float[] xyz = colors.get(i);
            // Channels are differences of numbers this many times the luminance, towards whose gray a color moves.
            double cancellation =
                    3.3 * (Math.abs(xyz[0]) + Math.abs(xyz[1]) + Math.abs(xyz[2])) / Math.max(xyz[1], 1e-30f);
            for (int c = 0; c < 3; c++) {
                assertThat((double) shown[4 * i + c])
                        .as("channel %d of %s", c, java.util.Arrays.toString(xyz))
                        .isCloseTo(expected[c], within(20 * DIGITS * cancellation * Math.max(1, expected[c])));
            }
        }
    }
}
