package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import picocli.CommandLine;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.gpu.BrdfMapRenderer;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;

/** Evaluates methods, given as command-line options, on one patch. */
final class MethodProbe {
    private final DiffractionSetup setup;

    MethodProbe(Path home, String patchOptions) {
        PatchOptions patch = CommandLine.populateCommand(new PatchOptions(), words(patchOptions));
        setup = new DiffractionSetup(
                patch.load(Choices.none()), new Environment(Map.of(), home), new PrintWriter(new StringWriter(), true));
    }

    DiffractionSetup setup() {
        return setup;
    }

    /** Returns light and viewer in the x-z plane; angles in degrees, negative towards -x. */
    static DirectionPair inPlane(double lightDegrees, double viewDegrees) {
        return new DirectionPair(Direction.ofDegrees(lightDegrees, 0), Direction.ofDegrees(viewDegrees, 0));
    }

    /** Returns views in the x-z plane from -x to +x, under light along the normal. */
    static List<DirectionPair> gratingPlane(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> inPlane(0, Math.toDegrees(Math.asin(-0.97 + 1.94 * i / (count - 1)))))
                .toList();
    }

    MethodPlan plan(VisibleRange range, String options) {
        MethodOptions parsed = CommandLine.populateCommand(new MethodOptions(), words(options));
        Choices choices = parsed.choices();
        return choices.located(() ->
                Methods.of(choices).plan(setup.withLight(LightTable.of(choices)).surface(), range));
    }

    static String[] words(String options) {
        return options.isEmpty() ? new String[0] : options.split(" ");
    }

    List<float[]> colors(List<DirectionPair> pairs, String options) {
        return evaluate(pairs.stream().map(pair -> new DirectionQuery(pair, 0)), MethodUse.COLOR, options);
    }

    /** Returns coherent power and ensemble power at one wavelength in meters. */
    List<float[]> powers(List<DirectionPair> pairs, double wavelength, String options) {
        return evaluate(pairs.stream().map(pair -> new DirectionQuery(pair, wavelength)), MethodUse.SPECTRAL, options);
    }

    /** Returns the same values for one pair at each whole nanometer from 380 to 780. */
    List<float[]> spectrum(DirectionPair pair, String options) {
        IntStream nanometers = IntStream.rangeClosed(380, 780);
        return evaluate(nanometers.mapToObj(nm -> new DirectionQuery(pair, nm * 1e-9)), MethodUse.SPECTRAL, options);
    }

    private List<float[]> evaluate(Stream<DirectionQuery> stream, MethodUse use, String options) {
        List<DirectionQuery> queries = stream.toList();
        List<DirectionPair> pairs =
                queries.stream().map(DirectionQuery::pair).distinct().toList();
        ShaderTables tables = setup.tables(plan(VisibleRange.of(pairs), options), use);
        return evaluate(queries, tables, use == MethodUse.SPECTRAL);
    }

    static List<float[]> evaluate(List<DirectionQuery> queries, ShaderTables tables, boolean isSpectral) {
        try (RenderContext context = RenderContext.offscreen();
                UploadedTables method = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, isSpectral)) {
            return renderer.evaluate(queries, count -> {});
        }
    }

    /** Asserts that each pixel in the disc of a map has a color; its size is odd, so that the middle one is u = v = 0. */
    void assertMapHasColors(String options) {
        int size = 21;
        Direction normal = new Direction(0, 0, 1);
        ShaderTables tables = setup.tables(plan(VisibleRange.of(normal), options), MethodUse.COLOR);
        LinearPicture map;
        try (RenderContext context = RenderContext.offscreen();
                UploadedTables method = UploadedTables.upload(context, tables);
                BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size, 0)) {
            map = renderer.render(normal, pixels -> {});
        }
        for (int pixel = 0; pixel < size * size; pixel++) {
            double x = (2.0 * (pixel % size) + 1) / size - 1;
            double y = (2.0 * Math.floorDiv(pixel, size) + 1) / size - 1;
            assertThat(map.luminance(pixel) >= 0 && Float.isFinite(map.luminance(pixel)))
                    .as("pixel %d of %s", pixel, options)
                    .isEqualTo(x * x + y * y < 1);
        }
    }

    /** Returns the relative distance of two colors in XYZ. */
    static double relativeError(float[] actual, float[] expected) {
        double difference = 0;
        double size = 0;
        for (int c = 0; c < 3; c++) {
            difference += Math.pow(actual[c] - expected[c], 2);
            size += Math.pow(expected[c], 2);
        }
        return Math.sqrt(difference / size);
    }
}
