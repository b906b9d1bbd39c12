package sunbeam.app.measure.benchmark;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import jrtr.RenderContext;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.GpuColors;
import sunbeam.app.measure.benchmark.FrameTimer.Timing;
import sunbeam.app.measure.benchmark.Measured.Errors;
import sunbeam.app.measure.errors.Comparison;
import sunbeam.app.measure.errors.ErrorStatistics;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Measures methods by maps of one light. Nothing comes from the cache.
 *
 * @param timer of the maps
 * @param light towards the light
 */
record Meter(FrameTimer timer, Direction light) {

    /** The same by maps of another size. */
    Meter of(int size) {
        return new Meter(new FrameTimer(timer.context(), size, timer.frames()), light);
    }

    /**
     * What a method takes.
     *
     * @param name of the method in the report
     * @param exact at which its error is measured; nothing where it is not
     * @throws sunbeam.precompute.setting.SettingException when the method makes no sense for the surface
     * @throws jrtr.GraphicsException when the graphics card has no room for it
     */
    Measured measure(DiffractionSetup setup, String name, Method method, Optional<ExactViews> exact) {
        RenderContext context = timer.context();
        long start = System.nanoTime();
        MethodPlan plan = method.plan(setup.surface(), VisibleRange.of(light));
        ShaderTables tables = setup.freshTables(plan, MethodUse.COLOR, GpuColors::of);
        try (UploadedTables drawn = UploadedTables.upload(context, tables)) {
            context.finish();
            double making = (System.nanoTime() - start) * 1e-9;
            Timing timing = timer.time(drawn, light);
            boolean comparable = method.brightness() == Method.Brightness.OF_A_MIRROR;
            Optional<Errors> errors = exact.filter(views -> comparable)
                    .map(views -> errors(views.compare(context, method, drawn), timing.exposure()));
            return new Measured(setup.patch().name(), name, words(plan), making, tables.bytes(), timing, errors);
        }
    }

    private static String words(MethodPlan plan) {
        return plan.sums()
                .map(sums -> String.format(
                        Locale.ROOT,
                        "%s, %d %s terms",
                        plan.summary(),
                        sums.expansion().terms(),
                        sums.expansion().kind().label()))
                .orElseGet(plan::summary);
    }

    private static Errors errors(List<Comparison> compared, double exposure) {
        return new Errors(
                Comparison.relative(compared),
                ErrorStatistics.of(compared.stream()
                        .mapToDouble(view -> view.colorDifference(exposure))
                        .toArray()));
    }
}
