package sunbeam.app.viewer;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.plan.PlanRequest;

/**
 * The plan of moving pictures: the same surface, planned for what keeps the colours (the sources of error that the
 * tolerance bounds stay well below it, and below what the low resolution hides), and a coherence length of half the
 * scene's, which needs half the wavelengths. It blurs colours by no more than a preview's pixels do.
 */
final class PreviewPlan {
    private static final double TOLERANCE = 0.4;
    // Shorter ones blur colours by more than 2 degrees: as wide as a preview's pixel on a curved skin, and seen.
    private static final double SHORTEST_COHERENCE_LENGTH = 20e-6;
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
                method == MethodKind.FULL ? OptionalDouble.of(shorter(request)) : request.coherenceLength(),
                request.average());
    }

    private static double shorter(PlanRequest request) {
        double length = request.window().coherenceLength();
        return Math.min(length, Math.max(length / 2, SHORTEST_COHERENCE_LENGTH));
    }

    /**
     * Factor of the relative radiance that keeps the BRDF where the window is another one: the mirror to which radiance
     * relates grows with the window's area (design, section 3).
     */
    static double radianceScale(PlanRequest request, PlanRequest preview) {
        double ratio = preview.window().coherenceLength() / request.window().coherenceLength();
        return ratio * ratio;
    }
}
