package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.accuracy.ReferenceSamples.Power;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.table.FourierTable;

/** How fast each expansion of exp(i k w h) converges, in double precision and in the shader's float32. */
final class TermsExperiment implements Experiment {
    // Sums over the surface for every term and direction take their time: fewer directions will do.
    private static final int MOST_DIRECTIONS = 30;
    private static final int MOST_TERMS = 48;
    // It needs half as many as Chebyshev's, and each takes a transform of its own.
    private static final int MOST_LOWRANK_TERMS = 24;
    private static final int POINTS = 12;

    @Override
    public int cost() {
        return 60;
    }

    @Override
    public ErrorFigure run(Subject subject) {
        List<Power> powers = thinned(subject.samples().powers());
        List<Query> queries = powers.stream().map(Power::query).toList();
        List<ErrorCurve> curves = new ArrayList<>();
        for (ExpansionKind kind : ExpansionKind.values()) {
            int most = kind == ExpansionKind.LOWRANK ? MOST_LOWRANK_TERMS : MOST_TERMS;
            Plan plan = subject.plan(Variants.ofExpansion(kind, most), queries);
            FourierTable table = subject.setup().freshTable(plan);
            int[] counts = counts(table.terms());
            ErrorCurve.Builder single = new ErrorCurve.Builder(kind.label() + " float32");
            for (int terms : counts) {
                single.add(terms, subject.powerErrors(plan, table.firstTerms(terms), powers));
            }
            curves.add(new DoubleSums(subject.samples().evaluator(), plan.expansion()).errors(powers, counts));
            curves.add(single.build());
        }
        return new ErrorFigure(
                "terms",
                subject.name() + ": error over number of terms",
                Axis.linear("number of terms"),
                "relative error of power (median)",
                "terms",
                curves,
                List.of(thesis(subject, powers, queries)),
                ErrorFigure.Style.MEDIANS,
                List.of());
    }

    private static ErrorCurve thesis(Subject subject, List<Power> powers, List<Query> queries) {
        Plan plan = subject.plan(Variants.ofThesisExpansion(), queries);
        FourierTable table = subject.setup().freshTable(plan);
        return ErrorCurve.point(
                "thesis", plan.expansion().terms(), ErrorStatistics.of(subject.powerErrors(plan, table, powers)));
    }

    /** About evenly spread from 1 to a largest number, without repetition. */
    private static int[] counts(int most) {
        return IntStream.rangeClosed(0, POINTS - 1)
                .map(i -> 1 + (int) Math.round((double) i * (most - 1) / (POINTS - 1)))
                .distinct()
                .toArray();
    }

    private static List<Power> thinned(List<Power> powers) {
        int stride = Math.max(1, (powers.size() + MOST_DIRECTIONS - 1) / MOST_DIRECTIONS);
        return IntStream.range(0, powers.size())
                .filter(i -> i % stride == 0)
                .mapToObj(powers::get)
                .toList();
    }
}
