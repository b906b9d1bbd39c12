package sunbeam.precompute.analysis;

import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/**
 * Estimated periods of faulty scans and of surfaces without a grating, as a table. Not among the tests: {@code ./sunbeam test -Dtest=FaultyScansRun}, with {@code -Dsunbeam.seed=N} for
 * other draws, {@code -Dsunbeam.draws=N} for more of each kind and {@code -Dsunbeam.kind=K} for one kind.
 */
class FaultyScansRun {
    private static final long FIRST_SEED = Long.getLong("sunbeam.seed", 3000);
    private static final int DRAWS = Integer.getInteger("sunbeam.draws", 30);
    private static final String KIND = System.getProperty("sunbeam.kind", "");

    @Test
    void printTable() {
        System.out.println("kind              held   missed   refused");
        for (FaultyScan.Kind kind : FaultyScan.Kind.values()) {
            if (KIND.isEmpty() || kind.name().equals(KIND)) {
                print(kind);
            }
        }
    }

    private static void print(FaultyScan.Kind kind) {
        int held = 0;
        int missed = 0;
        for (long seed = FIRST_SEED; seed < FIRST_SEED + DRAWS; seed++) {
            FaultyScan scan = FaultyScan.draw(kind, seed);
            Optional<GratingPeriod> estimate = scan.estimate();
            if (estimate.filter(scan::holdsTruth).isPresent()) {
                held++;
            } else if (estimate.isPresent()) {
                missed++;
                System.out.println("  missed: " + scan.words() + ": " + estimate.get());
            }
        }
        System.out.printf(Locale.ROOT, "%-14s %7d %8d %9d%n", kind, held, missed, DRAWS - held - missed);
    }
}
