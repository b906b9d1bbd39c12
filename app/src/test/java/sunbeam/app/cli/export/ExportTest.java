package sunbeam.app.cli.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import jrtr.gl.FloatTexture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.InAContext;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

/**
 * Translations of the exported function, compiled to GLSL by other programs and compared with the original on the same directions. A test
 * is skipped if its compiler is missing. And the number of pairs that an export compares.
 */
class ExportTest extends InAContext {
    private static final int SIDE = 64;
    private static final int TABLE = 32;
    private static final int SLICES = 6;
    // Four floats a texel.
    private static final int LAYER = 4 * TABLE * TABLE;

    // Both do the same operations in float32, but llvmpipe fuses and reorders them, and Kirchhoff's factor magnifies
    // small differences.
    private static final double ROUNDING = 2e-4;

    /** A light and a viewer for each pixel, some below the horizon; footprints from none to a third of all directions. */
    private static final String MAIN = """
            vec3 shown(vec2 pixel) {
                vec2 at = pixel / 64.0;
                float radius = 0.98 * sqrt(at.x);
                vec3 wi = vec3(radius * cos(40.0 * at.y), radius * sin(40.0 * at.y), sqrt(1.0 - radius * radius) - 0.2);
                vec3 wr = normalize(vec3(sin(31.0 * at.x), cos(17.0 * at.x + 5.0 * at.y), 1.0));
                return sunbeam(normalize(wi), wr, 0.1 * at.x * wr, 0.3 * at.y * at.y * wi);
            }
            """;

    private static final String FRAGMENT = """
            in vec4 gl_FragCoord;
            layout(location = 0) out vec4 color;
            void main() { color = vec4(shown(gl_FragCoord.xy), 1.0); }
            """;

    @TempDir
    Path folder;

    private static String glsl() {
        Map<String, String> values = new HashMap<>();
        values.putAll(Map.of("U", "-1.5", "V", "-1.4", "STEP", "0.1", "COLUMNS", TABLE + ".0", "ROWS", TABLE + ".0"));
        values.putAll(Map.of("DEPTH", "0.3", "DEPTH_STEP", "0.35", "SLICES", SLICES + ".0", "SIGMA", "0.01"));
        values.put("COARSEST", "3.0");
        return ShaderText.fill(ShaderText.read("sunbeam.glsl"), values) + MAIN;
    }

    @Test
    void hlslComputesWhatGlslDoes() throws Exception {
        Files.writeString(
                folder.resolve("hlsl.frag"),
                ShaderText.Language.HLSL
                                .translate(glsl())
                                .replace(
                                        "shown(float2",
                                        "shown(Texture2DArray<float4> sunbeamTable, SamplerState sunbeamSampler, float2")
                        + "Texture2DArray<float4> lookUp; SamplerState linearClamp;\n"
                        + "float4 main(float4 at : SV_Position) : SV_Target {"
                        + " return float4(shown(lookUp, linearClamp, at.xy), 1.0); }\n");

        run("glslangValidator", "-D", "-V", "-e", "main", "-S", "frag", "--amb", "-o", "hlsl.spv", "hlsl.frag");
        String back = run("spirv-cross", "hlsl.spv", "--version", "330", "--no-es", "--no-420pack-extension");

        assertAlike(back);
    }

    @Test
    void wgslComputesWhatGlslDoes() throws Exception {
        Files.writeString(
                folder.resolve("it.wgsl"),
                ShaderText.Language.WGSL
                                .translate(glsl().replace("vec3 shown(vec2 pixel) {", "@SHOWN@"))
                                .replace(
                                        "@SHOWN@",
                                        "fn shown(sunbeamTable: texture_2d_array<f32>, sunbeamSampler: sampler, pixel: vec2f)"
                                                + " -> vec3f {")
                        + "@group(0) @binding(0) var lookUp: texture_2d_array<f32>;\n"
                        + "@group(0) @binding(1) var linearClamp: sampler;\n"
                        + "@fragment fn main(@builtin(position) at: vec4f) -> @location(0) vec4f {"
                        + " return vec4f(shown(lookUp, linearClamp, at.xy), 1.0); }\n");

        run("naga", "--profile", "core330", "--entry-point", "main", "it.wgsl", "it.frag");

        assertAlike(Files.readString(folder.resolve("it.frag")));
    }

    private void assertAlike(String other) {
        float[] expected = drawn("#version 330 core\n" + ShaderText.Language.GLSL.translate(glsl()) + FRAGMENT);
        float[] got = drawn(other);

        int lit = 0;
        for (int i = 0; i < expected.length; i++) {
            lit += i % 4 < 3 && expected[i] != 0 ? 1 : 0;
            assertThat((double) got[i])
                    .as("component %d of pixel %d", i % 4, i / 4)
                    .isCloseTo(expected[i], within(ROUNDING * (1 + Math.abs(expected[i]))));
        }
        assertThat(lit).isGreaterThan(SIDE * SIDE);
    }

    private float[] drawn(String shader) {
        FloatTexture.Spec spec = FloatTexture.Spec.array(TABLE, TABLE, SLICES, FloatTexture.Format.RGBA32F)
                .with(FloatTexture.Filter.LINEAR);
        SplittableRandom random = new SplittableRandom(3);
        float[] roots = new float[SLICES * LAYER];
        for (int i = 0; i < roots.length; i++) {
            roots[i] = (float) (256 * random.nextDouble());
        }
        String sampler = shader.replaceFirst("(?s).*?uniform (?:highp )?sampler2DArray (\\w+).*", "$1");
        try (FloatTexture table = context.createFloatTexture("table", spec)) {
            for (int slice = 0; slice < SLICES; slice++) {
                table.uploadLayer(slice, FloatBuffer.wrap(roots, slice * LAYER, LAYER));
            }
            return drawn(shader, SIDE, SIDE, Map.of(sampler, table), program -> {});
        }
    }

    private String run(String... command) throws IOException, InterruptedException {
        Path output = folder.resolve("output");
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
        Process process;
        try {
            process = builder.redirectErrorStream(true)
                    .redirectOutput(output.toFile())
                    .start();
        } catch (IOException missing) {
            return abort("skipped: no " + command[0]);
        }
        int code = process.waitFor();
        String said = Files.readString(output);
        assertThat(code).as("%s: %s", String.join(" ", command), said).isZero();
        return said;
    }

    private static final List<DirectionPair> AIMED = pairs(10);
    private static final List<DirectionPair> UNIFORM = pairs(40);

    /** As many of the pairs as the limit of products allows, perhaps none; half of them are on orders. */
    @ParameterizedTest
    @CsvSource({"1e6, 4, 1e9, 4", "4e8, 4, 1e9, 2", "1e12, 4, 1e9, 0", "1e12, 6, Infinity, 6", "1, 0, 1e9, 0"})
    void costlyPairsAreFew(double cost, int count, double most, int compared) {
        assertThat(TableMetadata.GridErrors.choose(AIMED, UNIFORM, pair -> cost, count, most))
                .isEqualTo(IntStream.range(0, compared)
                        .mapToObj(i -> (i % 2 == 0 ? AIMED : UNIFORM).get(i / 2))
                        .toList());
    }

    private static List<DirectionPair> pairs(double phiDegrees) {
        return IntStream.range(0, 8)
                .mapToObj(i -> new DirectionPair(Direction.ofDegrees(0, 0), Direction.ofDegrees(10 * i, phiDegrees)))
                .toList();
    }
}
