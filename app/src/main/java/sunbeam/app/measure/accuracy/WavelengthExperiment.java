package sunbeam.app.measure.accuracy;

import java.util.List;
import sunbeam.app.files.plot.Plot.Axis;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.app.measure.accuracy.ReferenceSamples.Color;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.table.FourierTable;

/** What equal steps of the wavelength miss of narrow orders. */
final class WavelengthExperiment implements Experiment {
    private static final double[] STEPS_NM = {0.5, 1, 2, 5, 10, 20};
    private static final double THESIS_STEP_NM = 5;

    @Override
    public int cost() {
        return 20;
    }

    @Override
    public ErrorFigure run(Subject subject) {
        List<Color> colors = subject.samples().colors();
        List<Query> queries = colors.stream().map(Color::query).toList();
        FourierTable table = null;
        ErrorCurve.Builder builder = new ErrorCurve.Builder("XYZ");
        for (double step : STEPS_NM) {
            Plan plan = subject.plan(Variants.ofWavelengthStep(step * 1e-9), queries);
            // Only the wavelengths differ from plan to plan.
            table = table == null ? subject.setup().freshTable(plan) : table;
            builder.add(step, subject.colorErrors(plan, table, colors));
        }
        ErrorCurve curve = builder.build();
        int thesis = curve.x().indexOf(THESIS_STEP_NM);
        return new ErrorFigure(
                "wavelength",
                subject.name() + ": error over wavelength step",
                Axis.logarithmic("wavelength step / nm"),
                "relative error of XYZ",
                "step nm",
                List.of(curve),
                List.of(ErrorCurve.point(
                        "thesis", THESIS_STEP_NM, curve.errors().get(thesis))),
                ErrorFigure.Style.MEDIANS_AND_PERCENTILES,
                List.of());
    }
}
