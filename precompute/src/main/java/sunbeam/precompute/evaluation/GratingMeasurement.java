package sunbeam.precompute.evaluation;

import java.util.List;
import java.util.Optional;

/**
 * A grating's period from its response, by the grating equation.
 *
 * @param candidates all ridges where the first order was looked for, the strongest first
 * @param ridge the strongest, followed
 * @param interpolated the period from peaks between samples: the better estimate
 * @param sampled the period from peaks on the grid's samples, as the thesis takes them; its variance grows with the
 *     square of the angles' step
 */
public record GratingMeasurement(
        List<RidgeSearch.Candidate> candidates, Ridge ridge, PeriodStatistics interpolated, PeriodStatistics sampled) {
    // A variance of fewer says nothing.
    private static final int FEWEST = 3;

    public GratingMeasurement {
        candidates = List.copyOf(candidates);
    }

    /**
     * Measures a response; empty where no ridge of at least three wavelengths is found.
     *
     * @param sigmaFrequency deviation of the window's spectrum, cycles per metre
     */
    public static Optional<GratingMeasurement> of(ResponseMatrix response, FirstOrder where, double sigmaFrequency) {
        List<RidgeSearch.Candidate> candidates =
                RidgeSearch.search(response, where.shortest(), where.longest(), sigmaFrequency);
        if (candidates.isEmpty()) {
            return Optional.empty();
        }
        Ridge ridge = new RidgeTracker(response, sigmaFrequency)
                .follow(candidates.get(0).frequency());
        if (ridge.size() < FEWEST) {
            return Optional.empty();
        }
        return Optional.of(new GratingMeasurement(
                candidates, ridge, PeriodStatistics.of(ridge.periods()), PeriodStatistics.of(ridge.sampledPeriods())));
    }

    /** +1 or -1, the sign of u: -1 on the side of the mirror towards the normal for a light at grazing angles. */
    public int order() {
        return candidates.get(0).frequency() < 0 ? -1 : 1;
    }
}
