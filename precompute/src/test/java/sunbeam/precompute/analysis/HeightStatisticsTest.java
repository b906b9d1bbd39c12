package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;

final class HeightStatisticsTest {
    private static final double PITCH = 20e-9;

    @Test
    void aSineHasTheRoughnessAndSlopesOfItsFormula() {
        double amplitude = 100e-9;
        double period = 2e-6;
        HeightMap map = Surfaces.of(400, 10, PITCH, (x, y) -> 5e-3 + amplitude * Math.sin(2 * Math.PI * x / period));
        HeightStatistics statistics = HeightStatistics.of(map);
        double steepest = 2 * Math.PI * amplitude / period;
        assertThat(statistics.relief()).isCloseTo(2 * amplitude, within(1e-15));
        // Four whole periods: exact but for the heights' rounding at an offset of 5 mm, 1e-18 m.
        assertThat(statistics.rms()).isCloseTo(amplitude / Math.sqrt(2), within(1e-15));
        // Differences over 1/100 of a period, half of that from the steepest place: 2/3 (pi / 100)^2 = 6.6e-4 less.
        assertThat(statistics.largestSlope()).isCloseTo(steepest, within(7e-4 * steepest));
        assertThat(statistics.rmsSlope()).isCloseTo(steepest / Math.sqrt(2), within(3e-3 * steepest));
        assertThat(statistics.steepShare()).isZero();
    }

    @Test
    void slopesAreOfTheSteepestDirection() {
        HeightStatistics statistics = HeightStatistics.of(Surfaces.of(30, 30, PITCH, (x, y) -> 0.3 * x - 0.4 * y));
        assertThat(statistics.largestSlope()).isCloseTo(0.5, within(1e-9));
        assertThat(statistics.rmsSlope()).isCloseTo(0.5, within(1e-9));
    }

    @Test
    void whatIsSteeperThan30DegreesIsCounted() {
        // A quarter of the intervals rises by 1.5 times the pitch, the rest falls by half of it.
        HeightMap map = Surfaces.of(
                41, 1, PITCH, (x, y) -> PITCH * new double[] {0, 1.5, 1, 0.5}[(int) Math.rint(x / PITCH) % 4]);
        assertThat(HeightStatistics.of(map).steepShare()).isEqualTo(0.25);
    }

    @Test
    void aSlopeOfExactly30DegreesIsNotSteeper() {
        assertThat(HeightStatistics.of(Surfaces.of(50, 1, PITCH, (x, y) -> x / Math.sqrt(3)))
                        .steepShare())
                .isZero();
    }

    @Test
    void aSingleSampleIsFlat() {
        HeightStatistics statistics = HeightStatistics.of(Surfaces.of(1, 1, PITCH, (x, y) -> 3e-9));
        assertThat(statistics).isEqualTo(new HeightStatistics(0, 0, 0, 0, 0));
    }

    /** 256 levels in 100 bins: each holds 1 %, but for the ends, beyond which there is nothing. */
    @Test
    void aHistogramHoldsTheWholeSurfaceAndIsNoComb() {
        SplittableRandom random = new SplittableRandom(6);
        HeightMap map = Surfaces.of(200, 200, PITCH, (x, y) -> 1.5e-9 * random.nextInt(256) - 190e-9);
        Histogram histogram = Histogram.of(map, 100);
        assertThat(Arrays.stream(histogram.shares()).sum()).isCloseTo(1, within(1e-12));
        assertThat(histogram.centers()[99]).isCloseTo(map.maximum(), within(1e-15));
        for (int bin = 1; bin < 99; bin++) {
            // 400 of 40,000 samples scatter by 5 %; four times that.
            assertThat(histogram.shares()[bin]).isCloseTo(1 / 99.0, within(0.2 / 99));
        }
    }

    @Test
    void aFlatPatchHasOneBin() {
        Histogram histogram = Histogram.of(Surfaces.of(5, 5, PITCH, (x, y) -> 7e-9), 100);
        assertThat(histogram.shares()).containsExactly(1);
        assertThat(histogram.centers()).containsExactly(7e-9);
    }
}
