package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.plot.Plot;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuBaker;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.errors.Comparison;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;

/**
 * How colors depend on a scan's resolution: {@code full} on scans of fewer samples, taken between those that there are, against the
 * whole scan, at random views of one light.
 */
record Resolutions(RenderContext context, Environment environment, Direction light, GaussianArea area) {
    // A hundredth of what is measured.
    private static final double TOLERANCE = 1e-4;
    static final int VIEWS = 2000;

    private static final long SEED = 5;

    /** The error of X, Y and Z of a scan of so many samples along its width, the pitch in metres. */
    record Point(String patch, int samples, double pitch, ErrorStatistics errors) {
        Map<String, Object> fields() {
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("patch", patch);
            fields.put("samples", samples);
            fields.put("pitch_nm", pitch * 1e9);
            fields.put("median_relative_error", errors.median());
            fields.put("percentile95_relative_error", errors.percentile95());
            fields.put("views", errors.count());
            return fields;
        }
    }

    /** @param samples along the patch's width, fewer than it has */
    List<Point> measure(Patch patch, List<Integer> samples) {
        List<Point> points = new ArrayList<>();
        HeightMap whole = patch.heights();
        DirectionSampler sampler = new DirectionSampler(whole, area.window(), SEED, Optional.of(light));
        List<Query> queries = Stream.concat(
                        Stream.generate(sampler::uniform).limit(VIEWS / 2),
                        Stream.generate(sampler::aimed).limit(VIEWS / 2))
                .toList();
        try (Progress progress = Progress.start("Resolutions of " + patch.name(), samples.size() + 1L)) {
            List<float[]> exact = colors(patch, whole, queries);
            progress.step(1);
            for (int count : samples) {
                HeightMap coarse = Growth.resampled(whole, (double) count / whole.columns());
                points.add(
                        new Point(patch.name(), count, coarse.pitchX(), errors(colors(patch, coarse, queries), exact)));
                progress.step(1);
            }
        }
        return points;
    }

    private List<float[]> colors(Patch patch, HeightMap heights, List<Query> queries) {
        DiffractionSetup setup = Growth.setup(environment, patch, heights);
        MethodPlan plan = FullMethod.within(TOLERANCE).with(area).plan(setup.surface(), VisibleRange.of(light));
        try (UploadedTables drawn =
                        UploadedTables.upload(context, setup.freshTables(plan, MethodUse.COLOR, GpuBaker::of));
                DirectionsRenderer renderer = new DirectionsRenderer(context, drawn, false)) {
            return renderer.evaluate(queries, done -> {});
        }
    }

    private static ErrorStatistics errors(List<float[]> computed, List<float[]> exact) {
        return Comparison.relative(IntStream.range(0, exact.size())
                .mapToObj(i -> new Comparison(Comparison.xyz(computed.get(i), 0), Comparison.xyz(exact.get(i), 0), 1))
                .toList());
    }

    static Plot plot(List<Point> points) {
        Plot plot = new Plot(new Plot.Frame(
                "Error over the scan's resolution",
                Plot.Axis.logarithmic("distance of samples / nm"),
                Plot.Axis.logarithmic("relative error of XYZ"),
                900,
                480));
        points.stream().map(Point::patch).distinct().forEach(patch -> {
            List<Point> some =
                    points.stream().filter(point -> point.patch().equals(patch)).toList();
            line(plot, patch + ", median", some, ErrorStatistics::median);
            line(plot, patch + ", 95 %", some, ErrorStatistics::percentile95);
        });
        return plot;
    }

    private static void line(Plot plot, String name, List<Point> points, ToDoubleFunction<ErrorStatistics> error) {
        plot.line(
                name,
                points.stream().mapToDouble(point -> point.pitch() * 1e9).toArray(),
                points.stream()
                        .mapToDouble(point -> error.applyAsDouble(point.errors()))
                        .toArray());
    }
}
