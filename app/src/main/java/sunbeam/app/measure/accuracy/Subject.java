package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongConsumer;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.accuracy.ReferenceSamples.SampleCounts;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.CoherenceArea;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Plan;
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
     * @param journal of the exact values
     * @param mapSize width and height of maps that are timed, pixels
     * @param progress told how many exact colours are done, of {@link #cost}
     */
    Subject(
            String name,
            RenderContext context,
            DiffractionSetup setup,
            SampleCounts counts,
            ExactJournal journal,
            int mapSize,
            LongConsumer progress) {
        this.name = name;
        this.context = context;
        this.setup = setup;
        this.methods = new MethodMeter(context, this, mapSize);
        this.centred = samples(WindowOrigin.CENTRE, counts, journal, progress);
        // For one plan only, the thesis's, whose errors are large enough to be seen in fewer directions.
        this.cornered = samples(WindowOrigin.CORNER, half(counts), journal, progress);
    }

    /** Exact colours that a subject computes. */
    static int cost(SampleCounts counts) {
        return counts.colors() + half(counts).colors();
    }

    private static SampleCounts half(SampleCounts counts) {
        return new SampleCounts(counts.powers() / 2, counts.colors() / 2, counts.seed());
    }

    private ReferenceSamples samples(
            WindowOrigin origin, SampleCounts counts, ExactJournal journal, LongConsumer progress) {
        String subject = Version.number() + "|" + setup.patch().digest();
        return new ReferenceSamples(
                setup.patch().heights(), WINDOW, origin, setup.cie(), counts, journal, subject, progress);
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
    ReferenceSamples samplesFor(Method method) {
        CoherenceArea exact = method.exact(setup.patch().heights()).area();
        return exact instanceof GaussianArea area && area.origin() == WindowOrigin.CORNER ? cornered : centred;
    }

    /** A plan for some directions. */
    Plan plan(FullMethod method, List<Query> queries) {
        List<DirectionPair> pairs = queries.stream().map(Query::pair).toList();
        return method.tablePlan(setup.surface(), VisibleRange.of(pairs));
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
