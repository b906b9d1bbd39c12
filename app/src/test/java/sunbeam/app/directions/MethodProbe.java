package sunbeam.app.directions;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import picocli.CommandLine;
import sunbeam.app.brdf.BrdfMapRenderer;
import sunbeam.app.cli.Environment;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.app.setup.MethodOptions;
import sunbeam.app.setup.Methods;
import sunbeam.app.setup.PatchOptions;
import sunbeam.app.setup.PlanOptions;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Geometry;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;

/** One patch, and methods on it as the command line asks for them. */
final class MethodProbe {
    private final DiffractionSetup setup;

    MethodProbe(Path home, String... patchOptions) {
        PatchOptions patch = CommandLine.populateCommand(new PatchOptions(), patchOptions);
        setup = new DiffractionSetup(patch, new Environment(Map.of(), home), new PrintWriter(new StringWriter(), true));
    }

    DiffractionSetup setup() {
        return setup;
    }

    /** Light and viewer in the plane of incidence along x; angles in degrees, negative ones to the left. */
    static Geometry inPlane(double lightDegrees, double viewDegrees) {
        return new Geometry(Direction.ofDegrees(lightDegrees, 0), Direction.ofDegrees(viewDegrees, 0));
    }

    /** Directions along the grating's plane, lit from the normal, from the left horizon to the right. */
    static List<Geometry> gratingPlane(int count) {
        List<Geometry> geometries = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double sine = -0.97 + 1.94 * i / (count - 1);
            geometries.add(inPlane(0, Math.toDegrees(Math.asin(sine))));
        }
        return geometries;
    }

    MethodPlan plan(VisibleRange range, String... options) {
        CommandLine line = new CommandLine(new Options()).setCaseInsensitiveEnumValuesAllowed(true);
        Options parsed = line.getCommand();
        line.parseArgs(options);
        return Methods.plan(setup, parsed.method.request(), parsed.plan.request(), range);
    }

    /** X, Y, Z of the power. */
    List<float[]> colours(List<Geometry> geometries, String... options) {
        return evaluate(geometries, 0, MethodUse.COLOUR, options);
    }

    /** Coherent power, ensemble power, rho, BRDF at one wavelength in metres. */
    List<float[]> powers(List<Geometry> geometries, double wavelength, String... options) {
        return evaluate(geometries, wavelength, MethodUse.SPECTRAL, options);
    }

    private List<float[]> evaluate(List<Geometry> geometries, double wavelength, MethodUse use, String... options) {
        List<DirectionsRenderer.Query> queries = new ArrayList<>();
        geometries.forEach(geometry -> queries.add(new DirectionsRenderer.Query(geometry, wavelength)));
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables method = upload(context, plan(VisibleRange.of(geometries), options), use);
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, use == MethodUse.SPECTRAL)) {
            return renderer.evaluate(queries, count -> {});
        }
    }

    private UploadedTables upload(RenderContext context, MethodPlan plan, MethodUse use) {
        return UploadedTables.upload(context, setup.tables(plan, use));
    }

    /** A BRDF map, lit from the normal. */
    LinearPicture map(int size, String... options) {
        Direction normal = new Direction(0, 0, 1);
        try (RenderContext context = RenderContexts.offscreen();
                UploadedTables method = upload(context, plan(VisibleRange.of(normal), options), MethodUse.COLOUR);
                BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size)) {
            return renderer.render(normal, pixels -> {});
        }
    }

    /** Relative distance of two colours in XYZ. */
    static double relativeError(float[] actual, float[] expected) {
        double difference = 0;
        double size = 0;
        for (int c = 0; c < 3; c++) {
            difference += Math.pow(actual[c] - expected[c], 2);
            size += Math.pow(expected[c], 2);
        }
        return Math.sqrt(difference / size);
    }

    private static final class Options {
        @CommandLine.Mixin
        private MethodOptions method;

        @CommandLine.Mixin
        private PlanOptions plan;
    }
}
