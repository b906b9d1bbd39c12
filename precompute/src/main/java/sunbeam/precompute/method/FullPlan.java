package sunbeam.precompute.method;

import java.util.List;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanReport;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/**
 * Method {@code full}: all wavelengths, in the form that the plan's sampling has.
 *
 * @param surface the surface
 * @param plan made for it
 */
public record FullPlan(Surface surface, Plan plan) implements MethodPlan {

    @Override
    public String summary() {
        return new PlanReport(plan).summary();
    }

    @Override
    public List<String> reasons() {
        return new PlanReport(plan).reasons();
    }

    @Override
    public List<String> warnings() {
        return new Planner(surface.map(), surface.levels(), surface.cie()).warnings(plan);
    }

    @Override
    public MemoryNeed memory() {
        return MemoryNeed.of(plan, surface.map().rows());
    }

    @Override
    public String key(MethodUse use) {
        return String.join("|", "full", use.toString(), surface.key(), plan.key());
    }

    @Override
    public ShaderTables tables(MethodUse use, FourierTables fourier) {
        return plan.sampling().tables(plan, fourier.of(plan), use, surface.cie());
    }
}
