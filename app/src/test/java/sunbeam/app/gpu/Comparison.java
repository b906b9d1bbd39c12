package sunbeam.app.gpu;

import java.util.List;
import java.util.stream.IntStream;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.reference.WindowLight;
import sunbeam.precompute.shader.ShaderTables.MethodUse;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableBuilder;

/** One surface under one request, by method {@code full} on the GPU and by the reference. */
final class Comparison {
    /** Power below this counts as none: a tenth of the stray light in any instrument. */
    static final double FAINTEST = 1e-9;

    private final RenderContext context;
    private final HeightMap map;
    private final FullMethod full;
    private final CieTable cie = CieTable.load();
    private final ReferenceEvaluator reference;

    Comparison(RenderContext context, HeightMap map, FullMethod method) {
        this.context = context;
        this.map = map;
        this.full = method;
        this.reference = new ReferenceEvaluator(
                map, method.area().window(), method.area().origin());
    }

    SpectrumPlan plan(List<Query> queries) {
        List<DirectionPair> pairs = queries.stream().map(Query::pair).toList();
        return new Planner(map, HeightLevels.of(map), cie).plan(full.table(), full.area(), VisibleRange.of(pairs));
    }

    /** Coherent power, ensemble power, rho and brdf of each query, from the shaders. */
    List<float[]> spectral(List<Query> queries) {
        return evaluate(queries, true);
    }

    /** X, Y, Z of power and the gain of each direction, from the shaders. */
    List<float[]> colors(List<DirectionPair> pairs) {
        return evaluate(pairs.stream().map(g -> new Query(g, 0)).toList(), false);
    }

    private List<float[]> evaluate(List<Query> queries, boolean spectral) {
        SpectrumPlan plan = plan(queries);
        HeightLevels heights = HeightLevels.of(map);
        PatchIdentity identity =
                new PatchIdentity("test", map.columns(), map.rows(), map.pitchX(), map.pitchY(), map.digest());
        FourierTable table =
                new TableBuilder(identity, heights, done -> {}).build(plan.expansion(), plan.bandX(), plan.bandY());
        MethodUse use = spectral ? MethodUse.SPECTRAL : MethodUse.COLOR;
        try (UploadedTables method =
                        UploadedTables.upload(context, plan.sampling().tables(plan, table, use, cie));
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, spectral)) {
            return renderer.evaluate(queries, done -> {});
        }
    }

    /** Errors of the power, of the average that the request names, where there is any. */
    Errors powerErrors(List<Query> queries) {
        boolean ensemble = ensemble();
        List<float[]> computed = spectral(queries);
        double[] errors = IntStream.range(0, queries.size())
                .parallel()
                .mapToDouble(i -> {
                    Query query = queries.get(i);
                    ReferenceEvaluator.Power exact = reference.powers(query.pair(), query.wavelength());
                    double wanted = ensemble ? exact.ensemble() : exact.coherent();
                    return wanted < FAINTEST ? -1 : Math.abs(computed.get(i)[ensemble ? 1 : 0] - wanted) / wanted;
                })
                .filter(error -> !(error < 0))
                .toArray();
        return Errors.of(errors);
    }

    /** Errors of the colors as vectors, where there is any power. */
    Errors colorErrors(List<DirectionPair> pairs) {
        List<float[]> computed = colors(pairs);
        ExactLight light = new WindowLight(reference, cie, ensemble());
        double[] errors = IntStream.range(0, pairs.size())
                .parallel()
                .mapToDouble(i -> relative(computed.get(i), light.xyz(pairs.get(i), ExactLight.Quadrature.INTEGRATED)))
                .filter(error -> !(error < 0))
                .toArray();
        return Errors.of(errors);
    }

    private boolean ensemble() {
        return full.area().average() == Average.ENSEMBLE;
    }

    private static double relative(float[] computed, double[] exact) {
        double difference = 0;
        double length = 0;
        for (int c = 0; c < 3; c++) {
            difference += (computed[c] - exact[c]) * (computed[c] - exact[c]);
            length += exact[c] * exact[c];
        }
        return Math.sqrt(length) < FAINTEST ? -1 : Math.sqrt(difference / length);
    }
}
