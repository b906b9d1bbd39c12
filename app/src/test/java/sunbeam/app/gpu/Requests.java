package sunbeam.app.gpu;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;

/** What tests ask of the planner. */
final class Requests {
    /** The tolerance that these tests promise. */
    static final double TOLERANCE = 1e-3;

    private Requests() {}

    /** Planned for a tolerance of 1e-3. */
    static PlanRequest of(double coherenceLength, Average average) {
        return of(coherenceLength, average, WindowOrigin.CENTRE, Optional.empty());
    }

    static PlanRequest of(
            double coherenceLength, Average average, WindowOrigin origin, Optional<ExpansionKind> expansion) {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                TOLERANCE,
                expansion,
                OptionalInt.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.of(origin),
                OptionalDouble.of(coherenceLength),
                Optional.of(average));
    }
}
