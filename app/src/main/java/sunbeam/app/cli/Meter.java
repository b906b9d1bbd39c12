package sunbeam.app.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.BrdfMapRenderer;
import sunbeam.app.gpu.DirectionQuery;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.plan.MethodUse;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.plan.ShaderTables;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/**
 * Measures methods by drawing BRDF maps of one light, without the cache. A time is the median of several frames after a warm-up frame.
 * Short frames, which other processes disturb most, are repeated for half a second. No frame starts after {@link #MOST_SECONDS}; if the
 * warm-up frame takes longer than that, it is the only one.
 */
record Meter(RenderContext context, int size, Direction light) {
    static final int FRAMES = 3;
    static final double LEAST_SECONDS = 0.5;
    static final double MOST_SECONDS = 5;
    private static final int MOST_FRAMES = 1000;

    /**
     * Cost and error of a method on a surface.
     *
     * @param makingSeconds seconds from the heights to the tables on the graphics card
     * @param frameSeconds median time of a map
     * @param pixels number of the disc's pixels in the map
     * @param errors relative errors of X, Y, Z; without samples if not measured
     */
    record Measurement(
            String patch,
            String method,
            String plan,
            double makingSeconds,
            long bytes,
            double frameSeconds,
            int pixels,
            ErrorStatistics errors) {

        double secondsPerPixel() {
            return frameSeconds / pixels;
        }

        Map<String, Object> fields() {
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("patch", patch);
            fields.put("method", method);
            fields.put("pixels", pixels);
            fields.put("making_s", makingSeconds);
            fields.put("frame_s", frameSeconds);
            fields.put("pixel_s", secondsPerPixel());
            fields.put("bytes", bytes);
            fields.put("views", errors.count());
            fields.put("median_error_of_xyz", errors.median());
            fields.put("percentile_95_error_of_xyz", errors.percentile95());
            fields.put("maximum_error_of_xyz", errors.maximum());
            fields.put("plan", plan);
            return fields;
        }
    }

    /** @throws sunbeam.precompute.setting.SettingException if the method does not suit the surface */
    Measurement measure(DiffractionSetup setup, String name, Method method, Optional<ExactViews> exact) {
        long start = System.nanoTime();
        MethodPlan plan = method.plan(setup.surface().withStatistics(Roughness.Cache.NONE), VisibleRange.of(light));
        ShaderTables tables = setup.freshTables(plan, MethodUse.COLOR);
        try (UploadedTables drawn = UploadedTables.upload(context, tables)) {
            context.finish();
            double making = (System.nanoTime() - start) * 1e-9;
            ErrorStatistics errors = exact.filter(views -> method.isNormalizedToMirror())
                    .map(views -> Comparison.relative(views.compare(context, method, drawn)))
                    .orElseGet(ErrorStatistics::of);
            try (BrdfMapRenderer renderer = new BrdfMapRenderer(context, drawn, size, 0)) {
                String patch = setup.patch().name();
                double frame = frameSeconds(renderer);
                return new Measurement(
                        patch, name, words(plan), making, tables.bytes(), frame, renderer.coveredPixels(), errors);
            }
        }
    }

    private double frameSeconds(BrdfMapRenderer renderer) {
        List<Double> seconds = new ArrayList<>();
        double warm = seconds(renderer);
        double total = 0;
        if (warm > MOST_SECONDS) {
            // The first frame includes the shader's compilation, which is short compared with a frame this slow.
            seconds.add(warm);
            total = warm;
        }
        while (total < LEAST_SECONDS || (seconds.size() < FRAMES && total < MOST_SECONDS)) {
            double frame = seconds(renderer);
            seconds.add(frame);
            // A stopped clock would never reach the limit.
            total += Math.max(frame, LEAST_SECONDS / MOST_FRAMES);
        }
        Collections.sort(seconds);
        return seconds.get(seconds.size() / 2);
    }

    private double seconds(BrdfMapRenderer renderer) {
        context.finish();
        long start = System.nanoTime();
        renderer.draw(light, pixels -> {});
        context.finish();
        return Math.max(1, System.nanoTime() - start) * 1e-9;
    }

    private static String words(MethodPlan plan) {
        return plan.summary()
                + plan.fullSpectrumPlan()
                        .map(SpectrumPlan::expansion)
                        .map(sum -> Text.format(", %d %s terms", sum.terms(), ValueKind.name(sum.kind())))
                        .orElse("");
    }

    /** Random views of one light brighter than {@link Comparison#FLOOR}, with their exact colors: half uniform, half aimed at orders. */
    record ExactViews(DiffractionSetup setup, Direction light, int count, Map<ReferenceMethod, List<View>> views) {
        // Nearly all views of a grating are dark; the limit ends the search on a patch that is dark everywhere.
        private static final int MOST_TRIES_PER_VIEW = 30;
        // Views that are evaluated in parallel before the bright ones are counted.
        private static final int BATCH = 32;
        private static final long SEED = 3;

        record View(DirectionQuery query, double[] xyz) {}

        ExactViews(DiffractionSetup setup, Direction light, int count) {
            this(setup, light, count, new HashMap<>());
        }

        /** Compares a method's radiance, of tables for this light, with the reference under the method's window and average. */
        List<Comparison> compare(RenderContext context, Method method, UploadedTables drawn) {
            List<View> exact =
                    views.computeIfAbsent(method.referenceMethod(setup.patch().heights()), known -> draw(method));
            List<DirectionQuery> queries = exact.stream().map(View::query).toList();
            try (DirectionsRenderer renderer = new DirectionsRenderer(context, drawn, false)) {
                List<float[]> results = renderer.evaluate(queries, done -> {});
                return IntStream.range(0, exact.size())
                        .mapToObj(i -> comparison(results.get(i), exact.get(i)))
                        .toList();
            }
        }

        private static Comparison comparison(float[] computed, View exact) {
            double gain = Gain.relativeRadiance(exact.query().pair());
            return new Comparison(scaled(gain, Comparison.xyz(computed, 0)), scaled(gain, exact.xyz()), gain);
        }

        private static double[] scaled(double gain, double[] xyz) {
            return Arrays.stream(xyz).map(value -> gain * value).toArray();
        }

        private List<View> draw(Method method) {
            ExactLight exact = setup.exact(method);
            DirectionSampler sampler =
                    new DirectionSampler(setup.patch().heights(), exact.window(), SEED, Optional.of(light));
            try (Progress progress = setup.progress().start("Exact colors", count)) {
                List<View> all = new ArrayList<>(bright(sampler::uniform, count / 2, exact, progress));
                all.addAll(bright(sampler::aimed, count - count / 2, exact, progress));
                return all;
            }
        }

        /** Returns the first {@code wanted} views that are bright enough; the number of processors does not change them. */
        private static List<View> bright(
                Supplier<DirectionQuery> queries, int wanted, ExactLight exact, Progress progress) {
            List<View> found = new ArrayList<>();
            for (long tried = 0; found.size() < wanted && tried < (long) wanted * MOST_TRIES_PER_VIEW; ) {
                // No larger than the number of missing views: on a scan each view is bright and takes seconds.
                int batch = Math.min(BATCH, wanted - found.size());
                tried += batch;
                List<View> bright = Stream.generate(queries).limit(batch).toList().parallelStream()
                        .map(query -> new View(query, exact.xyz(query.pair(), ExactLight.Quadrature.INTEGRATED)))
                        .filter(view -> Comparison.largest(view.xyz()) > Comparison.FLOOR)
                        .toList();
                found.addAll(bright);
                progress.step(bright.size());
            }
            return found;
        }
    }
}
