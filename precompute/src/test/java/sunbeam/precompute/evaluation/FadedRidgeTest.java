package sunbeam.precompute.evaluation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.analysis.PeriodEstimate;
import sunbeam.precompute.patch.HeightMap;

class FadedRidgeTest {
    /** The repetition's comb draws these to 20 um / 22, 10 um / 11 and 36 um / 28, by 1 %. */
    @ParameterizedTest
    @CsvSource({"512, 39.0625, 900", "256, 39.0625, 900", "720, 50, 1300"})
    void noCombDrawsTheOrderAside(int columns, double pitchNm, double periodNm) {
        double pitch = pitchNm * 1e-9;
        double period = periodNm * 1e-9;
        double[] heights = new double[columns * 64];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = 50e-9 * Math.sin(2 * Math.PI * (i % columns) * pitch / period + 0.3);
        }
        HeightMap scan = new HeightMap(columns, 64, pitch, pitch, heights);
        GratingPlane plane = new GratingPlane(Math.toRadians(75), 0, 0);
        double wrong = period * 1.003;
        PeriodEstimate near =
                new PeriodEstimate(wrong, wrong, wrong, columns * pitch / period, Optional.empty(), Optional.empty());
        AtomicInteger sums = new AtomicInteger();
        FadedRidge ridge = new FadedRidge(scan, plane);
        double found = ridge.period(near, new double[] {400e-9, 450e-9, 500e-9, 550e-9, 600e-9}, sums::incrementAndGet)
                .orElseThrow();
        // Along the order the power falls, which draws its top by a hundredth of its width, 1 / W.
        assertThat(Math.abs(1 / found - 1 / period)).isLessThan(0.02 / (columns * pitch));
        assertThat(sums.get()).as("what progress is told of").isBetween(1, ridge.mostSums());
    }
}
