package sunbeam.app.commands.inspect;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.FewPeriods;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.PeriodRemedy;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.patch.HeightMap;

/**
 * How often something is told of a surface that has no period: makes the table of docs/evaluation.md. Not among the tests:
 * {@code ./sunbeam test -Dtest=FalseAlarmsRun}, with {@code -Dsunbeam.seed=N} for other draws and {@code -Dsunbeam.draws=N} for
 * more of each kind and {@code -Dsunbeam.kind=K} for one.
 */
class FalseAlarmsRun {
    private static final long FIRST_SEED = Long.getLong("sunbeam.seed", 0);
    private static final String KIND = System.getProperty("sunbeam.kind", "");
    private static final int DRAWS = Integer.getInteger("sunbeam.draws", 100);

    @Test
    void printTable() {
        System.out.println("kind             of   a peak   a period   a wave seen too few times   an option shows one");
        for (PeriodlessSurface kind : PeriodlessSurface.values()) {
            if (kind.name().contains(KIND)) {
                print(kind);
            }
        }
    }

    private static void print(PeriodlessSurface kind) {
        int[] alarms = new int[4];
        for (long seed = FIRST_SEED; seed < FIRST_SEED + DRAWS; seed++) {
            HeightMap scan = kind.draw(seed);
            Periodicity found = new PeriodFinder(scan, false).all();
            if (found.found()) {
                alarms[0]++;
                alarms[1] += PeriodEstimator.estimate(scan, found.peaks().get(0))
                                .filter(told -> PeriodJudgement.refusal(
                                                List.of(),
                                                Optional.of(told),
                                                found.peaks().get(0))
                                        .isEmpty())
                                .isPresent()
                        ? 1
                        : 0;
                System.out.println("  " + kind + " " + seed + ": " + found);
                continue;
            }
            if (FewPeriods.in(scan).isPresent()) {
                alarms[2]++;
                System.out.println(
                        "  " + kind + " " + seed + ": " + FewPeriods.in(scan).get());
            }
            if (PeriodRemedy.in(scan).isPresent()) {
                alarms[3]++;
                System.out.println(
                        "  " + kind + " " + seed + ": " + PeriodRemedy.in(scan).get());
            }
        }
        System.out.printf(
                Locale.ROOT, "%-14s %4d %8d %10d %27d %21d%n", kind, DRAWS, alarms[0], alarms[1], alarms[2], alarms[3]);
    }
}
