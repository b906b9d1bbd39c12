package sunbeam.app.viewer;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.plan.PlanRequest;

/**
 * The plan of moving pictures: the same surface and window, planned for what keeps the colours (the sources of error that
 * the tolerance bounds stay well below it, and below what the low resolution hides) at a quarter of the time of 0.05.
 */
final class PreviewPlan {
    private static final double TOLERANCE = 0.4;
    // Of pq, whose planned step is that of its sharp fringes: hundreds of wavelengths for a scan. Metres.
    private static final double REPLICAS_STEP = 20e-9;

    private PreviewPlan() {}

    static PlanRequest of(MethodKind method, PlanRequest request) {
        // With the thesis's preset nmm weighs no orders: another picture, not a finer one.
        return new PlanRequest(
                method == MethodKind.NMM ? request.preset() : PlanRequest.Preset.NONE,
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
