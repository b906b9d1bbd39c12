package sunbeam.app.setup;

import sunbeam.app.cli.UsageException;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.method.FullPlan;
import sunbeam.precompute.method.GemPlan;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.NmmPlan;
import sunbeam.precompute.method.PqPlan;
import sunbeam.precompute.method.Surface;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.units.Lengths;

/** The method that a user asks for, planned for a patch and the directions that can occur. */
public final class Methods {
    // Beyond, a patch is no single period of a grating whose colours can be seen.
    private static final double WIDEST_PERIOD = 10e-6;

    private Methods() {}

    /**
     * Plans a method.
     *
     * @param range directions that can occur
     * @throws UsageException when the method cannot do what is asked for
     */
    public static MethodPlan plan(
            DiffractionSetup setup, MethodRequest method, PlanRequest request, VisibleRange range) {
        return switch (method.kind()) {
            case FULL -> new FullPlan(setup.surface(), setup.plan(request, range));
            case NMM ->
                new NmmPlan(
                        setup.surface(),
                        setup.plan(request.orWavelengthStep(NmmPlan.WAVELENGTH_STEP), range),
                        request.isThesis() ? NmmPlan.Weighting.STEP : NmmPlan.Weighting.WIDTH);
            case PQ -> pq(setup, method, request, range);
            case GEM -> new GemPlan(spacing(setup.surface(), method), request.window());
            case REFERENCE ->
                throw new UsageException("--method reference evaluates single directions; use it with 'reflectance'");
        };
    }

    private static MethodPlan pq(
            DiffractionSetup setup, MethodRequest method, PlanRequest request, VisibleRange range) {
        if (request.average().orElse(Average.COHERENT) == Average.ENSEMBLE) {
            throw new UsageException("--average ensemble is not for --method pq, whose replicas lie at one place; leave"
                    + " it out or use --method full");
        }
        if (request.radius().isPresent() || request.anchor().isPresent()) {
            throw new UsageException(
                    "--radius and --anchor are not for --method pq, which has no neighbourhood of bins; leave them out");
        }
        Surface surface = setup.surface();
        Replicas replicas = method.replicasOf(surface.map(), request.window());
        Plan plan = setup.plan(request.orWavelengthStep(PqPlan.COARSEST_STEP), range);
        double planned =
                request.isThesis() ? PqPlan.COARSEST_STEP : PqPlan.wavelengthStep(surface.map(), replicas, range);
        return new PqPlan(
                surface,
                plan.expansion(),
                range,
                method.interpolation(),
                replicas,
                WavelengthNodes.uniform(surface.cie(), request.wavelengthStep().orElse(planned)));
    }

    private static double spacing(Surface surface, MethodRequest method) {
        double width = surface.map().width();
        if (method.spacing().isEmpty() && width > WIDEST_PERIOD) {
            throw new UsageException("--method gem needs --spacing: a patch that is " + Lengths.format(width)
                    + " wide is no single period; give the grating's, for example --spacing 1um");
        }
        return method.spacing().orElse(width);
    }
}
