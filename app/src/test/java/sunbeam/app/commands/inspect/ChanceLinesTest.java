package sunbeam.app.commands.inspect;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.analysis.PeriodEstimator;
import sunbeam.precompute.analysis.PeriodFinder;
import sunbeam.precompute.analysis.PeriodJudgement;
import sunbeam.precompute.analysis.SpectrumPeak;
import sunbeam.precompute.patch.HeightMap;

class ChanceLinesTest {
    /** 14 of 25 such surfaces were told a period, nine of the first twelve. */
    @Test
    void parallelLinesThatChancePutThereHaveNoPeriod() {
        List<String> told = new ArrayList<>();
        List<String> refused = new ArrayList<>();
        for (long seed = 0; seed < 12; seed++) {
            HeightMap scan = PeriodlessSurface.LINES.draw(seed);
            SpectrumPeak peak = new PeriodFinder(scan, false).all().peaks().get(0);
            Optional<PeriodEstimate> estimate = PeriodEstimator.estimate(scan, peak);
            PeriodJudgement.refusal(List.of(), estimate, peak)
                    .ifPresentOrElse(refused::add, () -> told.add(estimate.toString()));
        }
        // The highest of ten maxima of chance is, once in 25, so much higher than the others that they do not show it.
        assertThat(told).hasSizeLessThan(2);
        assertThat(refused).anySatisfy(why -> assertThat(why).contains("as where chance put the lines"));
    }
}
