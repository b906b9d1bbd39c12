package sunbeam.app.setup;

import sunbeam.app.cli.UsageException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.SettingException;

/** From requests to methods. */
public final class Methods {
    private Methods() {}

    /**
     * Plans a method.
     *
     * @param range directions that can occur
     */
    public static MethodPlan plan(
            DiffractionSetup setup, MethodRequest method, PlanRequest request, VisibleRange range) {
        try {
            return of(method, request).plan(setup.surface(), range);
        } catch (SettingException failure) {
            throw new UsageException(
                    "--" + failure.about().words("-") + " " + failure.problem().in(Origin.PROGRAM));
        }
    }

    private static Method of(MethodRequest method, PlanRequest request) {
        return switch (method.kind()) {
            case FULL -> new FullMethod(request.table(), request.neighbourhood(), request.area());
            case NMM -> new NmmMethod(request.table(), request.neighbourhood(), request.area());
            case PQ -> pq(method, request);
            case GEM -> new GemMethod(method.spacing(), request.window());
            case REFERENCE -> new ReferenceMethod(request.area());
        };
    }

    private static PqMethod pq(MethodRequest method, PlanRequest request) {
        if (request.average().orElse(Average.COHERENT) == Average.ENSEMBLE) {
            throw new UsageException("--average ensemble is not for --method pq, whose replicas lie at one place; leave"
                    + " it out or use --method full");
        }
        if (request.radius().isPresent() || request.anchor().isPresent()) {
            throw new UsageException(
                    "--radius and --anchor are not for --method pq, which has no neighbourhood of bins; leave them out");
        }
        return new PqMethod(request.table(), method.interpolation(), repetition(method, request));
    }

    private static PqMethod.Repetition repetition(MethodRequest method, PlanRequest request) {
        return method.replicas().isPresent()
                ? new PqMethod.Times(method.replicas().getAsInt())
                : new PqMethod.Filling(request.window());
    }
}
