package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.directions.DirectionsRenderer;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.shader.MethodUse;

/** Holds method {@code full} to its tolerance on the directions of a case. */
final class CaseRunner {
    private final RenderContext context;

    CaseRunner(RenderContext context) {
        this.context = context;
    }

    /** Whether a case kept its tolerance. */
    enum Verdict {
        KEPT,
        MISSED,
        /** The plan said before that it would miss. */
        MISSED_AS_SAID,
        /** The plan refused, and said why. */
        REFUSED
    }

    /**
     * What came of one case and tolerance.
     *
     * @param errors of the rows whose exact value, or computed one, is above 1e-9
     * @param plan the plan in a line, or why there is none
     */
    record Outcome(
            String name, String quantity, double tolerance, ErrorStatistics errors, Verdict verdict, String plan) {

        private String verdictInWords() {
            return verdict.toString().toLowerCase(Locale.ROOT).replace('_', ' ');
        }

        /** For programs. */
        Map<String, Object> fields() {
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("case", name);
            fields.put("quantity", quantity);
            fields.put("tolerance", tolerance);
            fields.put("verdict", verdictInWords());
            fields.put("plan", plan);
            if (verdict != Verdict.REFUSED) {
                fields.put("rows", errors.count());
                fields.put("median", errors.median());
                fields.put("percentile95", errors.percentile95());
                fields.put("maximum", errors.maximum());
            }
            return fields;
        }

        /** One line. */
        String line() {
            return verdict == Verdict.REFUSED
                    ? String.format(Locale.ROOT, "%-20s %-14s %.0e refused: %s", name, quantity, tolerance, plan)
                    : String.format(
                            Locale.ROOT,
                            "%-20s %-14s %.0e median %.1e p95 %.1e worst %.1e rows %4d %s; %s",
                            name,
                            quantity,
                            tolerance,
                            errors.median(),
                            errors.percentile95(),
                            errors.maximum(),
                            errors.count(),
                            verdictInWords(),
                            plan);
        }
    }

    /** Evaluates all rows of a case. */
    List<Outcome> run(AccuracyCase surface, DiffractionSetup setup, double tolerance) {
        Plan plan;
        try {
            plan = surface.method(tolerance)
                    .tablePlan(
                            setup.surface(),
                            VisibleRange.of(surface.directions().pairs()));
        } catch (SettingException refusal) {
            return List.of(new Outcome(
                    surface.name(), "-", tolerance, ErrorStatistics.of(), Verdict.REFUSED, refusal.getMessage()));
        }
        List<float[]> results = evaluate(surface, setup, plan);
        boolean said = !setup.surface().planner().warnings(plan).isEmpty();
        List<Outcome> outcomes = new ArrayList<>();
        for (String quantity : quantities(surface)) {
            double[] errors = errors(surface, quantity, results);
            ErrorStatistics statistics = ErrorStatistics.of(errors);
            Verdict missed = said ? Verdict.MISSED_AS_SAID : Verdict.MISSED;
            outcomes.add(new Outcome(
                    surface.name(),
                    quantity,
                    tolerance,
                    statistics,
                    statistics.meets(tolerance) ? Verdict.KEPT : missed,
                    new PlanReport(plan).summary()));
        }
        return outcomes;
    }

    private static List<String> quantities(AccuracyCase surface) {
        if (!surface.spectral()) {
            return List.of("XYZ");
        }
        return AccuracyCase.QUANTITIES.subList(0, 2).stream()
                .filter(surface.exact()::has)
                .map(column -> column.substring("exact_".length()))
                .toList();
    }

    private List<float[]> evaluate(AccuracyCase surface, DiffractionSetup setup, Plan plan) {
        DirectionList list = surface.directions();
        List<Query> queries = new ArrayList<>();
        for (int row = 0; row < list.size(); row++) {
            queries.add(new Query(list.pair(row), list.spectral() ? list.wavelength(row) : 0));
        }
        MethodUse use = list.spectral() ? MethodUse.SPECTRAL : MethodUse.COLOUR;
        try (UploadedTables method = UploadedTables.upload(
                        context, plan.sampling().tables(plan, setup.freshTable(plan), use, setup.cie()));
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, list.spectral())) {
            return renderer.evaluate(queries, done -> {});
        }
    }

    /** Relative errors of the rows that count: where there is light, or where the method sees some. */
    private static double[] errors(AccuracyCase surface, String quantity, List<float[]> results) {
        List<Double> errors = new ArrayList<>();
        for (int row = 0; row < results.size(); row++) {
            float[] result = results.get(row);
            boolean color = quantity.equals("XYZ");
            double[] computed = color
                    ? new double[] {result[0], result[1], result[2]}
                    : new double[] {quantity.equals("power") ? result[0] : result[1]};
            double[] exact = color
                    ? surface.exactXyz(row)
                    : new double[] {surface.exact().at(row, "exact_" + quantity)};
            if (!(Math.max(RelativeError.largest(exact), RelativeError.largest(computed)) <= RelativeError.FLOOR)) {
                errors.add(RelativeError.difference(computed, exact)
                        / Math.max(RelativeError.FLOOR, RelativeError.largest(exact)));
            }
        }
        return errors.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
