package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/**
 * Makes the table of docs/evaluation.md. Not among the tests: {@code ./sunbeam test -Dtest=SimulatedGratingsRun}, with
 * {@code -Dsunbeam.seed=N} for other draws and {@code -Dsunbeam.draws=N} for more of each kind.
 */
class SimulatedGratingsRun {
    private static final long FIRST_SEED = Long.getLong("sunbeam.seed", 3000);
    private static final int DRAWS = Integer.getInteger("sunbeam.draws", 30);

    @Test
    void printTable() {
        System.out.println("kind       holds   not answered   median half width %   median error %");
        for (SimulatedGrating.Kind kind : SimulatedGrating.Kind.values()) {
            print(kind);
        }
    }

    private static void print(SimulatedGrating.Kind kind) {
        int held = 0;
        List<Double> halfWidths = new ArrayList<>();
        List<Double> errors = new ArrayList<>();
        for (long seed = FIRST_SEED; seed < FIRST_SEED + DRAWS; seed++) {
            SimulatedGrating grating = SimulatedGrating.draw(kind, seed);
            Optional<PeriodEstimate> found = grating.estimate();
            if (found.isPresent()) {
                PeriodEstimate estimate = found.get();
                halfWidths.add(100 * estimate.halfWidth() / estimate.period());
                errors.add(100 * grating.error(estimate));
                if (grating.holdsTruth(estimate)) {
                    held++;
                } else {
                    System.out.println("  missed: " + grating.words() + ": " + estimate);
                }
            }
        }
        System.out.printf(
                Locale.ROOT,
                "%-9s %2d of %2d %8d %20.2g %18.2g%n",
                kind,
                held,
                errors.size(),
                DRAWS - errors.size(),
                median(halfWidths),
                median(errors));
    }

    private static double median(List<Double> values) {
        return values.stream().sorted().skip(values.size() / 2).findFirst().orElse(Double.NaN);
    }
}
