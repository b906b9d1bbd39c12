package sunbeam.app.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongConsumer;
import jrtr.RenderContext;
import sunbeam.app.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.certificate.RelativeError;
import sunbeam.app.directions.DirectionsRenderer;
import sunbeam.app.directions.DirectionsRenderer.Query;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Geometry;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.table.FourierTable;

/** One patch whose errors are measured on the GPU, with its exact samples. */
final class Subject {
    private static final CoherenceWindow WINDOW =
            CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);

    private final String name;
    private final RenderContext context;
    private final DiffractionSetup setup;
    private final MethodMeter methods;
    private final ReferenceSamples centred;
    private final ReferenceSamples cornered;

    /**
     * Computes the exact samples, which takes its time.
     *
     * @param mapSize width and height of maps that are timed, pixels
     * @param progress told how many exact colours are done, of {@link #cost}
     */
    Subject(
            String name,
            RenderContext context,
            DiffractionSetup setup,
            SampleCounts counts,
            int mapSize,
            LongConsumer progress) {
        this.name = name;
        this.context = context;
        this.setup = setup;
        this.methods = new MethodMeter(context, this, mapSize);
        this.centred = samples(WindowOrigin.CENTRE, counts, progress);
        // For one plan only, the thesis's, whose errors are large enough to be seen in fewer directions.
        this.cornered = samples(WindowOrigin.CORNER, half(counts), progress);
    }

    /** Exact colours that a subject computes. */
    static int cost(SampleCounts counts) {
        return counts.colors() + half(counts).colors();
    }

    private static SampleCounts half(SampleCounts counts) {
        return new SampleCounts(counts.powers() / 2, counts.colors() / 2, counts.seed());
    }

    private ReferenceSamples samples(WindowOrigin origin, SampleCounts counts, LongConsumer progress) {
        return new ReferenceSamples(setup.patch().heights(), WINDOW, origin, setup.cie(), counts, progress);
    }

    String name() {
        return name;
    }

    DiffractionSetup setup() {
        return setup;
    }

    /** Measures whole methods on this patch. */
    MethodMeter methods() {
        return methods;
    }

    ReferenceSamples samples() {
        return centred;
    }

    /** The thesis's window lies on the corner, and so must that of the exact values it is compared with. */
    ReferenceSamples samplesFor(PlanRequest request) {
        return request.windowOrigin() == WindowOrigin.CENTRE ? centred : cornered;
    }

    /** A plan for some directions. */
    Plan plan(PlanRequest request, List<Query> queries) {
        List<Geometry> geometries = queries.stream().map(Query::geometry).toList();
        return setup.plan(request, VisibleRange.of(geometries));
    }

    /** Relative errors of powers that the GPU computes. */
    double[] powerErrors(Plan plan, FourierTable table, List<ReferenceSamples.Power> samples) {
        List<Query> queries =
                samples.stream().map(ReferenceSamples.Power::query).toList();
        List<float[]> results = evaluate(plan, table, MethodUse.SPECTRAL, queries);
        double[] errors = new double[samples.size()];
        for (int i = 0; i < errors.length; i++) {
            errors[i] = RelativeError.of(results.get(i)[0], samples.get(i).power());
        }
        return errors;
    }

    /** Relative errors of X, Y, Z that the GPU computes. */
    double[] colorErrors(Plan plan, FourierTable table, List<ReferenceSamples.Color> samples) {
        List<Query> queries =
                samples.stream().map(ReferenceSamples.Color::query).toList();
        List<float[]> results = evaluate(plan, table, MethodUse.COLOUR, queries);
        double[] errors = new double[samples.size()];
        for (int i = 0; i < errors.length; i++) {
            float[] result = results.get(i);
            double[] xyz = {result[0], result[1], result[2]};
            errors[i] = RelativeError.ofColor(xyz, samples.get(i).xyz());
        }
        return errors;
    }

    private List<float[]> evaluate(Plan plan, FourierTable table, MethodUse use, List<Query> queries) {
        ShaderTables tables = plan.sampling().tables(plan, table, use, setup.cie());
        try (UploadedTables method = UploadedTables.upload(context, tables);
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, use == MethodUse.SPECTRAL)) {
            return new ArrayList<>(renderer.evaluate(queries, done -> {}));
        }
    }
}
