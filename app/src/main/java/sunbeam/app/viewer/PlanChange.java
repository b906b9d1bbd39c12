package sunbeam.app.viewer;

import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;

/** Plan requests with one choice changed. */
final class PlanChange {
    private PlanChange() {}

    /** Another preset; choices that only the other one has are given up. */
    static PlanRequest preset(PlanRequest old, PlanRequest.Preset preset) {
        PlanRequest fresh = PlanRequest.of(preset);
        return new PlanRequest(
                preset,
                old.tolerance(),
                fresh.expansion(),
                fresh.terms(),
                fresh.radius(),
                fresh.anchor(),
                fresh.wavelengthStep(),
                fresh.origin(),
                old.coherenceLength(),
                old.average());
    }

    static PlanRequest tolerance(PlanRequest old, double tolerance) {
        return with(old, tolerance, old.coherenceLength(), old.average());
    }

    /** @param metres four standard deviations of the window */
    static PlanRequest coherenceLength(PlanRequest old, double metres) {
        return with(old, old.tolerance(), OptionalDouble.of(metres), old.average());
    }

    static PlanRequest average(PlanRequest old, Average average) {
        return with(old, old.tolerance(), old.coherenceLength(), Optional.of(average));
    }

    private static PlanRequest with(
            PlanRequest old, double tolerance, OptionalDouble coherenceLength, Optional<Average> average) {
        return new PlanRequest(
                old.preset(),
                tolerance,
                old.expansion(),
                old.terms(),
                old.radius(),
                old.anchor(),
                old.wavelengthStep(),
                old.origin(),
                coherenceLength,
                average);
    }
}
