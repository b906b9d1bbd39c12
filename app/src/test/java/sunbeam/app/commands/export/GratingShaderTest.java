package sunbeam.app.commands.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.ShaderProgram;
import jrtr.glsl.ShaderLibrary;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.IntegratedNodes;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceColor;

/** Shaders of gratings, compiled as BRDF Explorer does, against the exact reference. */
@NeedsDisplay
class GratingShaderTest extends InAContext {
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(16e-6);
    private static final int PAIRS = 24;

    private static GratingShader shader(String name) {
        Patch patch = new Patch(name, BuiltInPatches.generate(name), "built in", List.of());
        return GratingShader.of(patch, WINDOW, CieTable.load());
    }

    private static ExactLight exact(GratingShader shader) {
        return new ReferenceMethod(new GaussianArea(WINDOW, WindowOrigin.CENTRE, Average.ENSEMBLE))
                .area()
                .over(shader.patch().heights(), shader.light());
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinusoid", "blaze", "lamellar"})
    void theFormulaIsTheReference(String name) {
        GratingShader shader = shader(name);
        ErrorStatistics errors = shader.errors(exact(shader));

        // The patch is sampled at 128 places of a period, the formula is not.
        assertThat(errors.count()).isGreaterThan(100);
        assertThat(errors.median()).isLessThan(0.01);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sinusoid", "blaze", "lamellar"})
    void theShaderReflectsWhatTheReferenceSays(String name) {
        GratingShader shader = shader(name);
        ExactLight exact = exact(shader);
        List<DirectionPair> pairs = pairs(shader);
        float[] drawn = drawn(shader.text(shader.errors(exact)), pairs);

        for (int i = 0; i < PAIRS; i++) {
            double[] expected = expected(exact, HeightLevels.of(shader.patch().heights()), pairs.get(i));
            double largest = Math.max(expected[0], Math.max(expected[1], expected[2]));
            for (int c = 0; c < 3; c++) {
                // The light's table has steps of 5 nm, the patch samples; skirts beyond 3.5 widths are left out.
                assertThat((double) drawn[4 * i + c])
                        .as("channel %d of %s", c, pairs.get(i))
                        .isCloseTo(Math.max(0, expected[c]), within(0.03 * largest + 1e-3));
            }
        }
    }

    /** Half of them in the plane of the orders. */
    private static List<DirectionPair> pairs(GratingShader shader) {
        DirectionSampler sampler = new DirectionSampler(shader.patch().heights(), WINDOW, 1);
        return Stream.concat(
                        IntStream.range(0, PAIRS / 2)
                                .mapToObj(i -> new DirectionPair(
                                        Direction.ofDegrees(i, 0), Direction.ofDegrees(3 * i, i % 2 == 0 ? 0 : 180))),
                        Stream.generate(() -> sampler.aimed().pair())
                                .filter(pair -> Math.min(pair.cosThetaI(), pair.cosThetaR()) > 0.2)
                                .limit(PAIRS / 2))
                .toList();
    }

    /** By an integral over wavelengths that the shader has no part in. */
    private static double[] expected(ExactLight exact, HeightLevels heights, DirectionPair pair) {
        DoubleUnaryOperator brdf = wavelength -> exact.power(pair, wavelength) * Gain.brdf(pair, WINDOW, wavelength);
        double step = ReferenceColor.step(WINDOW, heights, Math.hypot(pair.u(), pair.v()), -pair.w());
        double[] xyz = IntegratedNodes.of(CieTable.load(), step).sum(brdf);
        return IntStream.range(0, 3)
                .mapToDouble(c -> Srgb.linear(c, xyz[0], xyz[1], xyz[2]))
                .toArray();
    }

    private static float[] drawn(String file, List<DirectionPair> pairs) {
        String shader = glsl(file) + main(pairs);
        ShaderLibrary library = name -> name.equals("test.frag") ? Optional.of(shader) : Optional.empty();
        try (ShaderProgram program = context.createFullScreenProgram(library.load("test.frag"));
                FloatTarget target = context.createFloatTarget("test", FloatTargetSpec.color(PAIRS, 1))) {
            context.drawFullScreen(program, List.of(), target, Tile.whole(PAIRS, 1));
            return target.read(0);
        }
    }

    /** Parameters at their last value, and what stands between the shader's begin and end. */
    private static String glsl(String file) {
        StringBuilder glsl = new StringBuilder("#version 330 core\n");
        Matcher parameter = Pattern.compile("(?m)^(float|bool) (\\w+) (?:\\S+ \\S+ )?(\\S+)$")
                .matcher(between(file, "::begin parameters", "::end parameters"));
        while (parameter.find()) {
            String type = parameter.group(1);
            glsl.append("const " + type + " " + parameter.group(2) + " = " + type + "(" + parameter.group(3) + ");\n");
        }
        return glsl + between(file, "::begin shader", "::end shader");
    }

    private static String between(String text, String before, String after) {
        int from = text.indexOf(before) + before.length();
        return text.substring(from, text.indexOf(after, from));
    }

    private static String main(List<DirectionPair> pairs) {
        return "const vec3 LIGHTS[" + PAIRS + "] = vec3[]("
                + vectors(pairs.stream().map(DirectionPair::wi)) + ");\n"
                + "const vec3 VIEWS[" + PAIRS + "] = vec3[]("
                + vectors(pairs.stream().map(DirectionPair::wr)) + ");\n"
                + """
                layout(location = 0) out vec4 color;
                void main() {
                    int i = int(gl_FragCoord.x);
                    color = vec4(BRDF(LIGHTS[i], VIEWS[i], vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)), 1.0);
                }
                """;
    }

    private static String vectors(Stream<Direction> directions) {
        return directions
                .map(d -> String.format(Locale.ROOT, "vec3(%.9f, %.9f, %.9f)", d.x(), d.y(), d.z()))
                .collect(Collectors.joining(", "));
    }
}
