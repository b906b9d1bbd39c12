package sunbeam.app.viewer;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.plan.PlanRequest;

/** The plan of moving pictures: the same surface and window, planned for an error that is seen only in comparison. */
final class PreviewPlan {
    private static final double TOLERANCE = 0.05;
    // Of pq, whose planned step is that of its sharp fringes: hundreds of wavelengths for a scan. Metres.
    private static final double REPLICAS_STEP = 20e-9;

    private PreviewPlan() {}

    static PlanRequest of(MethodKind method, PlanRequest request) {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                Math.max(TOLERANCE, request.tolerance()),
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                method == MethodKind.PQ ? OptionalDouble.of(REPLICAS_STEP) : OptionalDouble.empty(),
                Optional.of(request.windowOrigin()),
                request.coherenceLength(),
                request.average());
    }
}
