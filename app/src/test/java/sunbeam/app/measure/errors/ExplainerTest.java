package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.shader.MethodUse;

/** Which source is named, and that the advice holds on other places, too. */
@NeedsDisplay
final class ExplainerTest {
    private static final int PLACES = 12;

    @TempDir
    private Path home;

    private DiffractionSetup setup() {
        PatchOptions patch = CommandLine.populateCommand(new PatchOptions(), "--patch", "sinusoid");
        return new DiffractionSetup(
                patch.load(), new Environment(Map.of(), home), new PrintWriter(new StringWriter(), true));
    }

    private static Choices choices(String... words) {
        return CommandLine.populateCommand(new MethodOptions(), words).choices();
    }

    /** In the plane of the grating, where its orders lie. */
    private static List<Query> queries(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return Stream.generate(() -> new Query(
                        new DirectionPair(
                                Direction.ofDegrees(0, 0),
                                Direction.ofDisc(random.nextDouble(-0.9, 0.9), random.nextDouble(-0.001, 0.001))),
                        random.nextDouble(380e-9, 780e-9)))
                .limit(PLACES)
                .toList();
    }

    private static VisibleRange range() {
        return VisibleRange.of(Direction.ofDegrees(0, 0));
    }

    private static Certificate certify(DiffractionSetup setup, Choices choices, MethodUse use, long seed) {
        List<Query> queries = queries(seed);
        Method method = Methods.of(choices);
        MethodPlan plan = method.plan(setup.surface(), range());
        List<double[]> results = new ArrayList<>();
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables tables = UploadedTables.upload(context, setup.freshTables(plan, use, GpuColours::of));
                DirectionsRenderer renderer = new DirectionsRenderer(context, tables, use == MethodUse.SPECTRAL)) {
            for (float[] values : renderer.evaluate(queries, done -> {})) {
                results.add(
                        use == MethodUse.COLOUR
                                ? new double[] {values[0], values[1], values[2]}
                                : new double[] {values[0]});
            }
        }
        ExactLight exact = setup.exact(method);
        return new TableCertifier(
                        queries::get,
                        results::get,
                        row -> use == MethodUse.COLOUR
                                ? exact.xyz(queries.get(row).pair(), Quadrature.INTEGRATED)
                                : new double[] {
                                    exact.power(
                                            queries.get(row).pair(),
                                            queries.get(row).wavelength())
                                },
                        use == MethodUse.COLOUR ? "XYZ" : "power")
                .certify(PLACES, PLACES, choices.get(MethodSettings.TOLERANCE));
    }

    @ParameterizedTest
    @CsvSource({
        "--terms 1, SPECTRAL, the expansion, leave out --terms, ''",
        "--expansion taylor --terms 2 --coherence-length 20um, COLOUR, the expansion, leave out --expansion and --terms,"
                + " --coherence-length 20um",
        "--radius 0 --coherence-length 4um, SPECTRAL, the neighbourhood, leave out --radius, --coherence-length 4um",
        "--wavelength-step 25nm, COLOUR, the wavelengths, leave out --wavelength-step, ''",
        "--preset thesis, COLOUR, the wavelengths, 'leave out --preset, and give --window-origin corner',"
                + " --window-origin corner",
        "--method nmm --tolerance 1e-4 --coherence-length 8um, COLOUR, nmm is an approximation, give --method full,"
                + " --method full --tolerance 1e-4 --coherence-length 8um"
    })
    void theSourceIsNamedAndTheAdviceHelpsElsewhereToo(
            String words, MethodUse use, String source, String advice, String followed) {
        DiffractionSetup setup = setup();
        Choices choices = choices(split(words));
        Certificate missed = certify(setup, choices, use, 1);
        assertThat(missed.missed()).as(missed.summary()).isTrue();
        assertThat(new Explainer(setup, choices, range(), use).explain(missed))
                .contains(source)
                .contains("; " + advice + ": the same places then keep the tolerance");
        // Other places than those that the advice was tried on.
        Certificate kept = certify(setup, choices(split(followed)), use, 2);
        assertThat(kept.relative().count()).isPositive();
        assertThat(kept.missed()).as(kept.summary()).isFalse();
    }

    private static String[] split(String words) {
        return Arrays.stream(words.split(" ")).filter(word -> !word.isEmpty()).toArray(String[]::new);
    }

    /** As if a driver computed wrongly: no approximation of the plan explains it, and float32 is what is left. */
    @Test
    void whatNoApproximationExplainsIsLeftToFloat32() {
        DiffractionSetup setup = setup();
        Choices choices = choices();
        Certificate right = certify(setup, choices, MethodUse.SPECTRAL, 1);
        List<ComparedPlace> wrong = right.compared().stream()
                .map(place ->
                        new ComparedPlace(place.query(), place.comparison().with(new double[] {
                            1.02 * place.comparison().computed()[0]
                        })))
                .toList();
        Certificate missed = new Certificate(
                "", false, "power", ErrorStatistics.of(0.02, 0.02), 0.02, ErrorStatistics.of(), 1e-3, wrong);
        assertThat(new Explainer(setup, choices, range(), MethodUse.SPECTRAL).explain(missed))
                .contains("float32");
    }
}
