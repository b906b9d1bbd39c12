package sunbeam.app.gpu;

import java.util.Optional;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.TableChoices;

/** Settings of method {@code full} in tests. */
final class Requests {
    /** Tolerance in these tests. */
    static final double TOLERANCE = 1e-3;

    private Requests() {}

    static FullMethod of(double coherenceLength, Average average) {
        return of(coherenceLength, average, WindowOrigin.CENTRE, Optional.empty());
    }

    static FullMethod of(
            double coherenceLength, Average average, WindowOrigin origin, Optional<ExpansionKind> expansion) {
        return new FullMethod(
                new TableChoices(
                        Optional.of(TOLERANCE), expansion, Optional.empty(), Optional.empty(), Optional.empty()),
                new GaussianArea(CoherenceWindow.ofCoherenceLength(coherenceLength), origin, average));
    }
}
