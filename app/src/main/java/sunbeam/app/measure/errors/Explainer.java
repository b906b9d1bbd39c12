package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colours.GpuColours;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.cause.ErrorSource;
import sunbeam.precompute.cause.PlanModel;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.MethodUse;

/** Says why a tolerance was missed, and what helps, which it tries on the very places that missed. */
public final class Explainer {
    private static final int WORST_PLACES = 3;

    private final DiffractionSetup setup;
    private final Choices choices;
    private final VisibleRange range;
    private final MethodUse use;

    /**
     * Explains results of one kind.
     *
     * @param choices that they were made with
     * @param range that they were planned for
     */
    public Explainer(DiffractionSetup setup, Choices choices, VisibleRange range, MethodUse use) {
        this.setup = setup;
        this.choices = choices;
        this.range = range;
        this.use = use;
    }

    /** One sentence: the source that errs most, and what helps. */
    public String explain(Certificate missed) {
        Method method = Methods.of(choices);
        MethodPlan plan = method.plan(setup.surface(), range);
        Optional<Blame> blame = plan.sums()
                .map(sums -> blame(
                        new PlanModel(sums, setup.patch().heights(), setup.cie(), () -> setup.freshTable(sums)),
                        missed.worst(WORST_PLACES)));
        String cause = blame.map(Blame::words)
                .orElseGet(() -> method.approximation()
                        .map(words -> method.type().label() + " is an approximation, whatever the tolerance: " + words)
                        .orElse(method.type().label() + " errs by more than was asked for"));
        return cause + "; " + advice(missed, method, blame.map(Blame::source));
    }

    /**
     * What errs most.
     *
     * @param error relative, of this source at the worst place
     * @param of the whole of it there
     */
    private record Blame(ErrorSource source, double error, double of) {
        String words() {
            return String.format(
                    Locale.ROOT,
                    "what errs most: %s, by %.1e at the worst place, which is wrong by %.1e",
                    source.words(),
                    error,
                    of);
        }
    }

    private Blame blame(PlanModel model, List<ComparedPlace> worst) {
        Map<ErrorSource, Double> sums = new EnumMap<>(ErrorSource.class);
        List<Map<ErrorSource, Double>> each =
                worst.parallelStream().map(place -> errors(model, place)).toList();
        each.forEach(errors -> errors.forEach((source, error) -> sums.merge(source, error, Double::sum)));
        ErrorSource guilty = sums.entrySet().stream()
                .max(Map.Entry.comparingByValue())
                .orElseThrow()
                .getKey();
        return new Blame(
                guilty, each.get(0).get(guilty), worst.get(0).comparison().relative());
    }

    /** How far each approximation moves the result, relative to what is exact. */
    private Map<ErrorSource, Double> errors(PlanModel model, ComparedPlace place) {
        Map<ErrorSource, double[]> values = new EnumMap<>(ErrorSource.class);
        if (use == MethodUse.COLOUR) {
            values.putAll(model.xyz(place.query().pair()));
        } else {
            model.powers(place.query().pair(), place.query().wavelength())
                    .forEach((source, power) -> values.put(source, new double[] {power}));
        }
        Comparison comparison = place.comparison().withoutGain();
        values.put(ErrorSource.FLOAT32, comparison.computed());
        Map<ErrorSource, Double> errors = new EnumMap<>(ErrorSource.class);
        double[] before = comparison.exact();
        double scale = Math.max(RelativeError.FLOOR, RelativeError.largest(before));
        for (Map.Entry<ErrorSource, double[]> next : values.entrySet()) {
            double moved = RelativeError.difference(next.getValue(), before) / scale;
            // What is no number is wrong without end.
            errors.put(next.getKey(), Double.isNaN(moved) ? Double.MAX_VALUE : moved);
            before = next.getValue();
        }
        return errors;
    }

    private String advice(Certificate missed, Method method, Optional<ErrorSource> source) {
        double best = Double.POSITIVE_INFINITY;
        for (Remedy remedy : Remedies.of(choices, method, source, missed.tolerance())) {
            Optional<ErrorStatistics> tried = tried(remedy, missed);
            if (tried.isPresent() && tried.get().meets(missed.tolerance())) {
                return String.format(
                        Locale.ROOT,
                        "%s: the same places then keep the tolerance (%s)",
                        remedy.words().in(OptionOrigin.INSTANCE),
                        tried.get());
            }
            best = Math.min(best, tried.map(ErrorStatistics::reached).orElse(best));
        }
        best = Math.min(best, missed.relative().reached());
        return String.format(
                Locale.ROOT,
                "nothing that can be chosen keeps the tolerance there, the best that was tried reaches %.1e;"
                        + " 'reflectance --method reference' has the exact values",
                best);
    }

    /** The errors of the same places with something else chosen; nothing where that cannot be. */
    private Optional<ErrorStatistics> tried(Remedy remedy, Certificate missed) {
        List<ComparedPlace> places = missed.compared();
        List<float[]> results;
        try (RenderContext context = RenderContexts.offscreen()) {
            MethodPlan plan = Methods.of(remedy.choices()).plan(setup.surface(), range);
            try (UploadedTables tables = UploadedTables.upload(context, setup.freshTables(plan, use, GpuColours::of));
                    DirectionsRenderer renderer = new DirectionsRenderer(context, tables, use == MethodUse.SPECTRAL)) {
                List<Query> queries = places.stream().map(ComparedPlace::query).toList();
                results = renderer.evaluate(queries, done -> {});
            }
        } catch (SettingException refused) {
            return Optional.empty();
        }
        List<Comparison> compared = new ArrayList<>();
        for (int i = 0; i < places.size(); i++) {
            compared.add(places.get(i).comparison().withoutGain().with(seen(results.get(i))));
        }
        return Optional.of(Comparison.relative(compared));
    }

    private double[] seen(float[] result) {
        if (use == MethodUse.COLOUR) {
            return new double[] {result[0], result[1], result[2]};
        }
        return new double[] {choices.get(MethodSettings.AVERAGE) == Average.ENSEMBLE ? result[1] : result[0]};
    }
}
