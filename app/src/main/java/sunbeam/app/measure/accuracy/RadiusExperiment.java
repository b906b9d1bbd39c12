package sunbeam.app.measure.accuracy;

import java.util.List;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.measure.accuracy.ReferenceSamples.Power;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Neighbourhood.Anchor;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.table.FourierTable;

/** What is lost with the DFT bins that a neighbourhood leaves out. */
final class RadiusExperiment implements Experiment {
    private static final int LARGEST = 5;
    private static final int THESIS_RADIUS = 1;

    @Override
    public int cost() {
        return 10;
    }

    @Override
    public ErrorFigure run(Subject subject) {
        List<Power> powers = subject.samples().powers();
        Plan widest = plan(subject, powers, new Neighbourhood(LARGEST, Anchor.NEAREST));
        FourierTable table = subject.setup().freshTable(widest);
        ErrorCurve floor = curve("floor", Anchor.FLOOR, subject, table);
        ErrorCurve nearest = curve("nearest", Anchor.NEAREST, subject, table);
        return new ErrorFigure(
                "radius",
                subject.name() + ": error over neighbourhood",
                Axis.linear("radius r of the (2 r + 1) x (2 r + 1) bins"),
                "relative error of power (median)",
                "radius",
                List.of(floor, nearest),
                List.of(ErrorCurve.point("thesis", THESIS_RADIUS, floor.errors().get(THESIS_RADIUS))),
                ErrorFigure.Style.MEDIANS,
                List.of());
    }

    private static ErrorCurve curve(String name, Anchor anchor, Subject subject, FourierTable table) {
        List<Power> powers = subject.samples().powers();
        ErrorCurve.Builder curve = new ErrorCurve.Builder(name);
        for (int radius = 0; radius <= LARGEST; radius++) {
            Plan plan = plan(subject, powers, new Neighbourhood(radius, anchor));
            curve.add(radius, subject.powerErrors(plan, table, powers));
        }
        return curve.build();
    }

    private static Plan plan(Subject subject, List<Power> powers, Neighbourhood neighbourhood) {
        return subject.plan(
                Variants.ofNeighbourhood(neighbourhood),
                powers.stream().map(Power::query).toList());
    }
}
