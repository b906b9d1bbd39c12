package sunbeam.app.commands.inspect;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.PeriodRemedy;
import sunbeam.precompute.analysis.Periodicity;
import sunbeam.precompute.patch.HeightMap;

/** Draws of which something was told once; how often of others, {@link FalseAlarmsRun} counts. */
class PeriodRemedyTest {
    @ParameterizedTest
    @CsvSource({"CORRELATED, 3", "CORRELATED, 38", "ROWS_OFFSET, 5", "ROWS_OFFSET, 23", "TERRACES, 11"})
    void nothingShowsAPeriodInWhatHasNone(PeriodlessSurface kind, long seed) {
        assertThat(PeriodRemedy.in(kind.draw(seed))).isEmpty();
    }

    /** A staircase of samples, and the ray of a step's own spectrum. */
    @ParameterizedTest
    @CsvSource({"12", "13", "18", "31"})
    void aSingleStepHasNoPeriod(long seed) {
        HeightMap scan = PeriodlessSurface.ONE_STEP.draw(seed);
        Periodicity found = new PeriodFinder(scan, false).all();
        assertThat(found.peaks().stream().findFirst().flatMap(peak -> PeriodEstimator.estimate(scan, peak)))
                .as(found.toString())
                .isEmpty();
    }
}
