package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import jrtr.GraphicsException;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.accuracy.ReferenceSamples.Color;
import sunbeam.app.measure.accuracy.ReferenceSamples.Power;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.FourierTable;

/** What a tolerance promises and what comes of it: power and X, Y, Z of plans made for nothing but a tolerance. */
final class ToleranceExperiment implements Experiment {
    private static final double[] TOLERANCES = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1};

    @Override
    public int cost() {
        return 20;
    }

    @Override
    public ErrorFigure run(Subject subject) {
        ErrorCurve.Builder power = new ErrorCurve.Builder("power");
        ErrorCurve.Builder color = new ErrorCurve.Builder("XYZ");
        List<String> remarks = new ArrayList<>();
        for (double tolerance : TOLERANCES) {
            try {
                double[][] errors = errors(subject, FullMethod.within(tolerance));
                power.add(tolerance, errors[0]);
                color.add(tolerance, errors[1]);
            } catch (GraphicsException | SettingException tooLarge) {
                remarks.add("Tolerance " + ErrorFigure.number(tolerance) + " was not measured: " + tooLarge.getMessage()
                        + ".");
            }
        }
        double[][] thesis = errors(subject, FullMethod.thesis());
        // It has no tolerance; its points stand where the coarsest one is.
        double place = TOLERANCES[TOLERANCES.length - 1];
        return new ErrorFigure(
                "tolerance",
                subject.name() + ": error over tolerance",
                Axis.logarithmic("tolerance"),
                "relative error",
                "tolerance",
                List.of(power.build(), color.build()),
                List.of(
                        ErrorCurve.point("thesis power", place, ErrorStatistics.of(thesis[0])),
                        ErrorCurve.point("thesis XYZ", place, ErrorStatistics.of(thesis[1]))),
                ErrorFigure.Style.AGAINST_TOLERANCE,
                remarks);
    }

    /** Errors of power, errors of X, Y, Z. */
    private static double[][] errors(Subject subject, FullMethod method) {
        List<Power> powers = subject.samplesFor(method).powers();
        List<Color> colors = subject.samplesFor(method).colors();
        List<Query> queries = new ArrayList<>();
        Stream.concat(powers.stream().map(Power::query), colors.stream().map(Color::query))
                .forEach(queries::add);
        Plan plan = subject.plan(method, queries);
        FourierTable table = subject.setup().freshTable(plan);
        return new double[][] {subject.powerErrors(plan, table, powers), subject.colorErrors(plan, table, colors)};
    }
}
