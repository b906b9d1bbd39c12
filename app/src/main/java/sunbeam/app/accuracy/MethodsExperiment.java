package sunbeam.app.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import jrtr.GraphicsException;
import sunbeam.app.accuracy.MethodsFigure.Entry;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.PlanException;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.resample.PeriodInterpolation;

/** Where the thesis's methods stand: error of X, Y, Z against the reference, and time per pixel. */
final class MethodsExperiment implements Experiment {
    private static final double[] TOLERANCES = {1e-2, 1e-3, 1e-4};
    // Beyond, a patch is no single period of a grating.
    private static final double WIDEST_PERIOD = 10e-6;

    @Override
    public int cost() {
        return 30;
    }

    @Override
    public Figure run(Subject subject) {
        List<Entry> entries = new ArrayList<>();
        List<String> remarks = new ArrayList<>();
        entries.add(subject.methods()
                .measure("full, thesis", full(), PlanRequest.of(PlanRequest.Preset.THESIS), MethodsFigure.FULL));
        for (double tolerance : TOLERANCES) {
            String name = "full, tolerance " + ErrorFigure.number(tolerance);
            try {
                entries.add(
                        subject.methods().measure(name, full(), Requests.withTolerance(tolerance), MethodsFigure.FULL));
            } catch (GraphicsException | PlanException tooLarge) {
                remarks.add(name + " was not measured: " + tooLarge.getMessage() + ".");
            }
        }
        PlanRequest standard = Requests.withTolerance(Tolerances.STANDARD);
        entries.add(subject.methods()
                .measure("nmm", MethodRequest.of(MethodKind.NMM), standard, "meant for patches of one period"));
        for (PeriodInterpolation interpolation : PeriodInterpolation.values()) {
            entries.add(subject.methods()
                    .measure(
                            "pq, " + interpolation.label(),
                            pq(interpolation),
                            standard,
                            "evenly lit replicas with sharp edges instead of the Gaussian window"));
        }
        gem(subject, standard, entries, remarks);
        return new MethodsFigure(subject.name(), entries, remarks);
    }

    private static void gem(Subject subject, PlanRequest request, List<Entry> entries, List<String> remarks) {
        OptionalDouble spacing = spacing(subject.setup().patch().heights());
        if (spacing.isEmpty()) {
            remarks.add("gem was not measured: the patch has no period to take for its spacing.");
            return;
        }
        String note = "lines %.0f nm apart and nothing of the surface; its brightness, which means nothing, is fitted"
                .formatted(1e9 * spacing.getAsDouble());
        MethodRequest method =
                new MethodRequest(MethodKind.GEM, PeriodInterpolation.SINC, OptionalInt.empty(), spacing);
        entries.add(subject.methods().measure("gem", method, request, note));
    }

    private static MethodRequest full() {
        return MethodRequest.of(MethodKind.FULL);
    }

    private static MethodRequest pq(PeriodInterpolation interpolation) {
        return new MethodRequest(MethodKind.PQ, interpolation, OptionalInt.empty(), OptionalDouble.empty());
    }

    /** The width of a patch of one period; otherwise the clearest period along x, across the lines. */
    private static OptionalDouble spacing(HeightMap map) {
        if (map.width() <= WIDEST_PERIOD) {
            return OptionalDouble.of(map.width());
        }
        CoherenceWindow sunlight = CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);
        Periodicity periods = new PeriodFinder(map).along(0, sunlight.sigmaFrequency());
        return periods.found() ? OptionalDouble.of(periods.peaks().get(0).period()) : OptionalDouble.empty();
    }
}
