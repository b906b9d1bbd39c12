package sunbeam.app.cli.benchmark;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.gl.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.DirectionsRenderer;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.terminal.Progress;
import sunbeam.precompute.errors.Comparison;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ExactLight.Quadrature;

/** Random views of one light brighter than {@link Comparison#FLOOR}, with their exact colors: half uniform, half aimed at orders. */
final class ExactViews {
    // Nearly all views of a grating are dark; the limit ends the search on a patch that is dark everywhere.
    private static final int MOST_TRIES_PER_VIEW = 30;

    /** Views that are evaluated in parallel before the bright ones are counted. */
    private static final int BATCH = 32;

    private static final long SEED = 3;

    private final DiffractionSetup setup;
    private final Direction light;
    private final int count;
    private final Map<ReferenceMethod, List<View>> views = new HashMap<>();

    private record View(Query query, double[] xyz) {}

    ExactViews(DiffractionSetup setup, Direction light, int count) {
        this.setup = setup;
        this.light = light;
        this.count = count;
    }

    /** Compares a method's radiance, of tables for this light, with the reference under the method's window and average. */
    List<Comparison> compare(RenderContext context, Method method, UploadedTables drawn) {
        List<View> exact =
                views.computeIfAbsent(method.referenceMethod(setup.patch().heights()), known -> draw(method));
        List<Query> queries = exact.stream().map(View::query).toList();
        try (DirectionsRenderer renderer = new DirectionsRenderer(context, drawn, false)) {
            List<float[]> results = renderer.evaluate(queries, done -> {});
            return IntStream.range(0, exact.size())
                    .mapToObj(i -> comparison(results.get(i), exact.get(i)))
                    .toList();
        }
    }

    private static Comparison comparison(float[] computed, View exact) {
        double gain = Gain.relativeRadiance(exact.query().pair());
        double[] one = new double[3];
        double[] other = new double[3];
        for (int c = 0; c < 3; c++) {
            one[c] = gain * computed[c];
            other[c] = gain * exact.xyz()[c];
        }
        return new Comparison(one, other, gain);
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
    private static List<View> bright(Supplier<Query> queries, int wanted, ExactLight exact, Progress progress) {
        List<View> found = new ArrayList<>();
        for (long tried = 0; found.size() < wanted && tried < (long) wanted * MOST_TRIES_PER_VIEW; ) {
            // No larger than the number of missing views: on a scan each view is bright and takes seconds.
            int batch = Math.min(BATCH, wanted - found.size());
            tried += batch;
            List<View> bright = Stream.generate(queries).limit(batch).toList().parallelStream()
                    .map(query -> new View(query, exact.xyz(query.pair(), Quadrature.INTEGRATED)))
                    .filter(view -> Comparison.largest(view.xyz()) > Comparison.FLOOR)
                    .toList();
            found.addAll(bright);
            progress.step(bright.size());
        }
        return found;
    }
}
