package sunbeam.app.measure.benchmark;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.errors.DirectionSampler;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;

/**
 * Random views of one light with their exact colours: half of them uniform on the hemisphere, half aimed at orders. What
 * tables of a map have in them is asked at places that no pixel need have.
 */
public final class MapSamples {
    // Of a grating nearly all views are dark; a patch that is dark everywhere must come to an end.
    private static final int MOST_TRIES_PER_SAMPLE = 30;
    private static final int BATCH = 32;

    private final DiffractionSetup setup;
    private final Direction light;
    private final int count;
    private final long seed;
    private final Map<ReferenceMethod, List<Sample>> samples = new HashMap<>();

    /** A view and the exact X, Y, Z of its power. */
    public record Sample(Query query, double[] xyz) {}

    /**
     * Nothing is computed yet.
     *
     * @param count of views
     * @param seed the same seed gives the same views
     */
    public MapSamples(DiffractionSetup setup, Direction light, int count, long seed) {
        this.setup = setup;
        this.light = light;
        this.count = count;
        this.seed = seed;
    }

    /**
     * Errors of a method against the reference, under the method's own window and average; views whose power is below
     * {@link RelativeError#FLOOR} are left out.
     *
     * @param drawn its tables for maps of the light
     */
    public ErrorStatistics errors(RenderContext context, Method method, UploadedTables drawn) {
        List<Sample> exact = samples(method);
        List<Query> queries = exact.stream().map(Sample::query).toList();
        try (DirectionsRenderer renderer = new DirectionsRenderer(context, drawn, false)) {
            List<float[]> results = renderer.evaluate(queries, done -> {});
            return ErrorStatistics.of(IntStream.range(0, exact.size())
                    .mapToDouble(i -> {
                        float[] xyz = results.get(i);
                        return RelativeError.ofColor(
                                new double[] {xyz[0], xyz[1], xyz[2]},
                                exact.get(i).xyz());
                    })
                    .toArray());
        }
    }

    /** What a method is held against; computed once for all methods that are held against the same. */
    public List<Sample> samples(Method method) {
        return samples.computeIfAbsent(method.exact(setup.patch().heights()), known -> draw(method));
    }

    private List<Sample> draw(Method method) {
        ExactLight exact = setup.exact(method);
        DirectionSampler sampler = new DirectionSampler(setup.patch().heights(), exact.window(), seed);
        try (Progress progress = Progress.start("Exact colours", count)) {
            List<Sample> all = new ArrayList<>(bright(() -> sampler.uniform(light), count / 2, exact, progress));
            all.addAll(bright(() -> sampler.aimed(light), count - count / 2, exact, progress));
            return all;
        }
    }

    /** The first so many that are bright enough; the same whatever the number of processors. */
    private static List<Sample> bright(Supplier<Query> views, int wanted, ExactLight exact, Progress progress) {
        List<Sample> found = new ArrayList<>();
        for (long tried = 0; found.size() < wanted && tried < (long) wanted * MOST_TRIES_PER_SAMPLE; ) {
            int batch = Math.min(BATCH, 2 * (wanted - found.size()));
            tried += batch;
            List<Query> queries = Stream.generate(views).limit(batch).toList();
            List<Sample> bright = queries.parallelStream()
                    .map(query -> new Sample(query, exact.xyz(query.pair(), Quadrature.INTEGRATED)))
                    .filter(sample -> RelativeError.largest(sample.xyz()) > RelativeError.FLOOR)
                    .toList();
            List<Sample> taken = bright.subList(0, Math.min(bright.size(), wanted - found.size()));
            found.addAll(taken);
            progress.step(taken.size());
        }
        return found;
    }
}
