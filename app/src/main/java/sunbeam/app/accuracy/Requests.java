package sunbeam.app.accuracy;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Neighbourhood.Anchor;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;

/** Plans in which one choice is varied and the others are as good as they get, so that only the one is seen. */
final class Requests {
    /** Seven bins a side around the nearest: error 1e-7 for the patches of 65 um (design section 4). */
    private static final Neighbourhood WIDE = new Neighbourhood(3, Anchor.NEAREST);

    private Requests() {}

    /** What a tolerance asks for, and nothing else. */
    static PlanRequest withTolerance(double tolerance) {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                tolerance,
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty());
    }

    /** A given expansion over a wide neighbourhood. */
    static PlanRequest ofExpansion(ExpansionKind kind, int terms) {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                Tolerances.FINEST,
                Optional.of(kind),
                OptionalInt.of(terms),
                OptionalInt.of(WIDE.radius()),
                Optional.of(WIDE.anchor()),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty());
    }

    /** The thesis's expansion over a wide neighbourhood, the window on the centre. */
    static PlanRequest ofThesisExpansion() {
        return new PlanRequest(
                PlanRequest.Preset.THESIS,
                Tolerances.STANDARD,
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.of(WIDE.radius()),
                Optional.of(WIDE.anchor()),
                OptionalDouble.empty(),
                Optional.of(WindowOrigin.CENTRE),
                OptionalDouble.empty(),
                Optional.empty());
    }

    /** The finest expansion over a given neighbourhood. */
    static PlanRequest ofNeighbourhood(Neighbourhood neighbourhood) {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                Tolerances.FINEST,
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.of(neighbourhood.radius()),
                Optional.of(neighbourhood.anchor()),
                OptionalDouble.empty(),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty());
    }

    /** The finest expansion over a wide neighbourhood, at wavelengths a given step apart. */
    static PlanRequest ofWavelengthStep(double metres) {
        return new PlanRequest(
                PlanRequest.Preset.NONE,
                Tolerances.FINEST,
                Optional.empty(),
                OptionalInt.empty(),
                OptionalInt.of(WIDE.radius()),
                Optional.of(WIDE.anchor()),
                OptionalDouble.of(metres),
                Optional.empty(),
                OptionalDouble.empty(),
                Optional.empty());
    }
}
