package sunbeam.app.measure.accuracy;

import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.plan.ErrorBudget;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.Neighbourhood.Anchor;

/** Method {@code full} with one choice varied and the others as good as they get, so that only the one is seen. */
final class Variants {
    /** Seven bins a side around the nearest: error 1e-7 for the patches of 65 um (design section 4). */
    private static final Neighbourhood WIDE = new Neighbourhood(3, Anchor.NEAREST);

    private static final FullMethod FINEST = FullMethod.within(ErrorBudget.FINEST);

    private static final double UNUSED_STEP = 5e-9;

    private Variants() {}

    /** A given expansion over a wide neighbourhood. */
    static FullMethod ofExpansion(ExpansionKind kind, int terms) {
        return FINEST.with(WIDE).with(FINEST.table().withExpansion(kind, terms));
    }

    /** The thesis's expansion over a wide neighbourhood, the window on the centre. */
    static FullMethod ofThesisExpansion() {
        return FullMethod.thesis().with(WIDE).with(GaussianArea.STANDARD);
    }

    /**
     * The finest expansion over a given neighbourhood, for powers at one wavelength each: its other wavelengths are few,
     * lest the plan be refused for loops that nobody runs.
     */
    static FullMethod ofNeighbourhood(Neighbourhood neighbourhood) {
        return FINEST.with(neighbourhood).with(FINEST.table().withWavelengthStep(UNUSED_STEP));
    }

    /** The finest expansion over a wide neighbourhood, at wavelengths a given step apart. */
    static FullMethod ofWavelengthStep(double metres) {
        return FINEST.with(WIDE).with(FINEST.table().withWavelengthStep(metres));
    }
}
