package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.text.Text;

/**
 * Estimated periods of simulated gratings, as a table. Not among the tests: {@code ./sunbeam test -Dtest=SimulatedGratingsRun}, with
 * {@code -Dsunbeam.seed=N} for other draws and {@code -Dsunbeam.draws=N} for more of each kind.
 */
class SimulatedGratingsRun {
    private static final long FIRST_SEED = Long.getLong("sunbeam.seed", 3000);
    private static final int DRAWS = Integer.getInteger("sunbeam.draws", 30);

    @Test
    void printTable() {
        System.out.println("kind       holds   not answered   median half width %   median error %   direction holds"
                + "   median half width, error, degrees");
        for (SimulatedGrating.Kind kind : SimulatedGrating.Kind.values()) {
            print(kind);
        }
    }

    private static void print(SimulatedGrating.Kind kind) {
        int held = 0;
        List<Double> halfWidths = new ArrayList<>();
        List<Double> errors = new ArrayList<>();
        Directions directions = new Directions();
        for (long seed = FIRST_SEED; seed < FIRST_SEED + DRAWS; seed++) {
            SimulatedGrating grating = SimulatedGrating.draw(kind, seed);
            Optional<GratingPeriod> found = grating.estimate();
            if (found.isPresent()) {
                GratingPeriod estimate = found.get();
                halfWidths.add(50 * (estimate.high() - estimate.low()) / estimate.period());
                errors.add(100 * grating.error(estimate));
                directions.add(grating, estimate);
                if (grating.holdsTruth(estimate)) {
                    held++;
                } else {
                    System.out.println("  missed: " + grating.words() + ": " + estimate);
                }
            }
        }
        System.out.printf(
                Locale.ROOT,
                "%-9s %2d of %2d %8d %20.2g %18.2g %10s%n",
                kind,
                held,
                errors.size(),
                DRAWS - errors.size(),
                median(halfWidths),
                median(errors),
                directions.words());
    }

    /** How often and how exactly directions are found. */
    private static final class Directions {
        private int held;
        private final List<Double> halfWidths = new ArrayList<>();
        private final List<Double> errors = new ArrayList<>();

        void add(SimulatedGrating grating, GratingPeriod estimate) {
            double error = grating.directionError(estimate);
            held += error <= estimate.azimuthHalfWidth() ? 1 : 0;
            halfWidths.add(Math.toDegrees(estimate.azimuthHalfWidth()));
            errors.add(Math.toDegrees(error));
        }

        String words() {
            return Text.format("%d of %d   %.2g   %.2g", held, errors.size(), median(halfWidths), median(errors));
        }
    }

    private static double median(List<Double> values) {
        return values.stream().sorted().skip(values.size() / 2).findFirst().orElse(Double.NaN);
    }
}
