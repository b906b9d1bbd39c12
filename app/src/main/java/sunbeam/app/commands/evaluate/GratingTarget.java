package sunbeam.app.commands.evaluate;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.units.Lengths;

/**
 * What an evaluation aims at, from what the user says and what the heights show.
 *
 * @param plane light and viewers
 * @param order where the first order is looked for
 * @param heights what the heights tell of the periods and directions that were asked for
 */
record GratingTarget(GratingPlane plane, FirstOrder order, GratingPeriod heights) {
    // A surface that repeats one small patch has its exact period; a grown one strays from the heights' mean period by
    // up to a quarter from one coherence area to the next.
    private static final double EXACT = 1.1;
    private static final double GROWN = 1.35;
    private static final double GIVEN = 1.2;
    private static final int DIGITS = 3;

    /**
     * Aims.
     *
     * @throws NoPeriodException where neither the user nor the heights name a period
     */
    static GratingTarget of(Patch patch, GratingRequest request) {
        OptionalDouble azimuth = request.azimuth();
        OptionalDouble period = request.period();
        Optional<FirstOrder> given =
                period.isPresent() ? Optional.of(FirstOrder.around(period.getAsDouble(), GIVEN)) : Optional.empty();
        GratingPeriod heights = heights(patch, azimuth, given);
        if (!heights.isTold() && given.isEmpty()) {
            throw new NoPeriodException(patch.name() + ": " + heights.refusal().orElseThrow()
                    + "; to look for a ridge all the same give "
                    + (azimuth.isEmpty() && !heights.hasWave() ? "--azimuth and --period" : "--period"));
        }
        FirstOrder order =
                given.orElseGet(() -> FirstOrder.around(heights.period(), heights.isExact() ? EXACT : GROWN));
        GratingPeriod aimed = heights.hasWave() || azimuth.isPresent() ? heights : GratingPeriod.of(patch);
        return new GratingTarget(request.plane(azimuth.orElse(aimed.azimuth())), order, heights);
    }

    private static GratingPeriod heights(Patch patch, OptionalDouble azimuth, Optional<FirstOrder> given) {
        try (Progress progress = Progress.start("Heights of " + patch.name(), 1)) {
            double shortest = given.map(FirstOrder::shortest).orElse(0.0);
            double longest = given.map(FirstOrder::longest).orElse(Double.POSITIVE_INFINITY);
            GratingPeriod heights = GratingPeriod.among(patch, azimuth, shortest, longest);
            progress.step(1);
            return heights;
        }
    }

    /** Why the heights tell no period where the order is looked for; empty where they do. */
    String doubt() {
        return heights.refusal().orElse("");
    }

    /** The period that the heights tell where the order is looked for; empty where they do not. */
    Optional<GratingPeriod> told() {
        return heights.isTold() ? Optional.of(heights) : Optional.empty();
    }

    /** What is said of a response without a ridge. */
    String noRidge() {
        return String.format(
                Locale.ROOT,
                "the response has no ridge of periods from %s to %s at 3 --wavelengths or more within --angles; choose more of them",
                Lengths.rounded(order.shortest(), DIGITS),
                Lengths.rounded(order.longest(), DIGITS));
    }
}
