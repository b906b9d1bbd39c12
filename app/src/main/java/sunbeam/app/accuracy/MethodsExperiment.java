package sunbeam.app.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import jrtr.GraphicsException;
import sunbeam.app.accuracy.MethodsFigure.Entry;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.setting.SettingException;

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
        entries.add(subject.methods().measure("full, thesis", FullMethod.thesis(), MethodsFigure.FULL));
        for (double tolerance : TOLERANCES) {
            String name = "full, tolerance " + ErrorFigure.number(tolerance);
            try {
                entries.add(subject.methods().measure(name, FullMethod.within(tolerance), MethodsFigure.FULL));
            } catch (GraphicsException | SettingException tooLarge) {
                remarks.add(name + " was not measured: " + tooLarge.getMessage() + ".");
            }
        }
        entries.add(subject.methods()
                .measure("nmm", NmmMethod.within(Tolerances.STANDARD), "meant for patches of one period"));
        for (PeriodInterpolation interpolation : PeriodInterpolation.values()) {
            entries.add(subject.methods()
                    .measure(
                            "pq, " + interpolation.label(),
                            PqMethod.within(Tolerances.STANDARD, interpolation),
                            "evenly lit replicas with sharp edges instead of the Gaussian window"));
        }
        gem(subject, entries, remarks);
        return new MethodsFigure(subject.name(), entries, remarks);
    }

    private static void gem(Subject subject, List<Entry> entries, List<String> remarks) {
        OptionalDouble spacing = spacing(subject.setup().patch().heights());
        if (spacing.isEmpty()) {
            remarks.add("gem was not measured: the patch has no period to take for its spacing.");
            return;
        }
        String note = "lines %.0f nm apart and nothing of the surface; its brightness, which means nothing, is fitted"
                .formatted(1e9 * spacing.getAsDouble());
        Method method = new GemMethod(spacing, GaussianArea.STANDARD.window());
        entries.add(subject.methods().measure("gem", method, note));
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
