package sunbeam.app.measure.accuracy;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.accuracy.MethodsFigure.Entry;
import sunbeam.app.measure.accuracy.ReferenceSamples.Color;
import sunbeam.app.measure.benchmark.FrameTimer;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;

/** Measures error and time of methods on one patch, each with a plan for what is drawn. */
final class MethodMeter {
    private static final Direction NORMAL = new Direction(0, 0, 1);
    private static final int FRAMES = 3;

    private final RenderContext context;
    private final Subject subject;
    private final int mapSize;

    /** @param mapSize width and height of the BRDF maps that are timed, pixels */
    MethodMeter(RenderContext context, Subject subject, int mapSize) {
        this.context = context;
        this.subject = subject;
        this.mapSize = mapSize;
    }

    /**
     * Measures one method.
     *
     * @param note what it approximates, see {@link Entry}
     */
    Entry measure(String name, Method method, String note) {
        List<Color> colors = subject.samplesFor(method).colors();
        List<Query> queries = colors.stream().map(Color::query).toList();
        DiffractionSetup setup = subject.setup();
        MethodPlan plan = method.plan(
                setup.surface(),
                VisibleRange.of(queries.stream().map(Query::pair).toList()));
        ErrorStatistics errors;
        try (UploadedTables drawn = upload(plan)) {
            double[][] xyz = evaluate(drawn, queries);
            if (method.brightness() == Method.Brightness.UNRELATED) {
                scale(xyz, colors);
            }
            errors = errors(xyz, colors);
        }
        return new Entry(name, errors, time(method), note);
    }

    /** Time per pixel of a map lit from the normal, microseconds, by a plan for that map: what a scene would draw with. */
    private double time(Method method) {
        DiffractionSetup setup = subject.setup();
        MethodPlan plan = method.plan(setup.surface(), VisibleRange.of(NORMAL));
        try (UploadedTables drawn = upload(plan)) {
            return new FrameTimer(context, mapSize, FRAMES).time(drawn, NORMAL).fastestMicrosecondsPerPixel();
        }
    }

    private UploadedTables upload(MethodPlan plan) {
        return UploadedTables.upload(context, subject.setup().freshTables(plan, MethodUse.COLOUR, GpuColours::of));
    }

    private double[][] evaluate(UploadedTables method, List<Query> queries) {
        try (DirectionsRenderer renderer = new DirectionsRenderer(context, method, false)) {
            return renderer.evaluate(queries, done -> {}).stream()
                    .map(rgba -> new double[] {rgba[0], rgba[1], rgba[2]})
                    .toArray(double[][]::new);
        }
    }

    private static ErrorStatistics errors(double[][] xyz, List<Color> colors) {
        return ErrorStatistics.of(IntStream.range(0, xyz.length)
                .mapToDouble(i -> RelativeError.ofColor(xyz[i], colors.get(i).xyz()))
                .toArray());
    }

    /** Multiplies colours that have no scale by the one factor that makes half of them too bright, half too dark. */
    private static void scale(double[][] xyz, List<Color> colors) {
        double[] ratios = IntStream.range(0, xyz.length)
                .filter(i -> xyz[i][1] > 0)
                .mapToDouble(i -> colors.get(i).xyz()[1] / xyz[i][1])
                .sorted()
                .toArray();
        double factor = ratios.length == 0 ? 1 : ratios[ratios.length / 2];
        for (double[] color : xyz) {
            Arrays.setAll(color, c -> factor * color[c]);
        }
    }
}
