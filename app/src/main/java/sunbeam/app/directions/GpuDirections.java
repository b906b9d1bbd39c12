package sunbeam.app.directions;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import sunbeam.app.gpu.DiffractionMethod;
import sunbeam.app.gpu.FullMethod;
import sunbeam.app.gpu.MethodUse;
import sunbeam.app.progress.Progress;
import sunbeam.app.setup.DiffractionSetup;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;

/** Directions by the shaders. */
final class GpuDirections {
    private final DiffractionSetup setup;
    private final PlanRequest request;
    private final Consumer<Plan> planned;

    /** @param planned told the plan before the work begins */
    GpuDirections(DiffractionSetup setup, PlanRequest request, Consumer<Plan> planned) {
        this.planned = planned;
        this.setup = setup;
        this.request = request;
    }

    List<double[]> evaluate(DirectionList list) {
        MethodUse use = list.spectral() ? MethodUse.SPECTRAL : MethodUse.COLOUR;
        Plan plan = setup.plan(request, VisibleRange.of(list.geometries()));
        planned.accept(plan);
        List<DirectionsRenderer.Query> queries = new ArrayList<>(list.size());
        for (int row = 0; row < list.size(); row++) {
            double wavelength = list.spectral() ? list.wavelength(row) : 0;
            queries.add(new DirectionsRenderer.Query(list.geometry(row), wavelength));
        }
        try (RenderContext context = RenderContexts.offscreen();
                DiffractionMethod method = FullMethod.create(context, plan, setup.table(plan), use, setup.cie());
                DirectionsRenderer renderer = new DirectionsRenderer(context, method, list.spectral());
                Progress progress = Progress.start("Directions", list.size())) {
            List<double[]> results = new ArrayList<>(list.size());
            for (float[] values : renderer.evaluate(queries, progress::step)) {
                results.add(new double[] {values[0], values[1], values[2], values[3]});
            }
            return results;
        }
    }
}
