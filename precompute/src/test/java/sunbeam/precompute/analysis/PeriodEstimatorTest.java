package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.patch.HeightMap;

class PeriodEstimatorTest {
    private static HeightMap sine(int columns, int rows, double pitch, double... periods) {
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            for (double period : periods) {
                heights[i] += 50e-9 * Math.cos(2 * Math.PI * pitch * (i % columns) / period + periods.length);
            }
        }
        return new HeightMap(columns, rows, pitch, pitch, heights);
    }

    private static Optional<PeriodEstimate> estimate(HeightMap map) {
        return PeriodEstimator.estimate(map, new PeriodFinder(map).all().peaks().get(0));
    }

    /** The scans of which the comb of the repetition made 909.10 nm and 1286.25 nm, +- 0.00. */
    @ParameterizedTest
    @CsvSource({
        "512, 39.0625, 900",
        "256, 39.0625, 900",
        "720, 50, 700",
        "720, 50, 1300",
        "720, 50, 3000",
        "720, 50, 8000"
    })
    void aCleanGratingIsKnownWell(int columns, double pitchNm, double periodNm) {
        PeriodEstimate estimate =
                estimate(sine(columns, 128, pitchNm * 1e-9, periodNm * 1e-9)).orElseThrow();
        assertThat(periodNm * 1e-9).isBetween(estimate.low(), estimate.high());
        // A thousandth of the scan's resolution, twice for the few periods, relative.
        double resolution = periodNm / (columns * pitchNm);
        assertThat(estimate.halfWidth() / estimate.period()).isLessThan(0.05 * resolution);
        assertThat(estimate.second()).isEmpty();
        assertThat(estimate.drift()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"1000, 1400", "1300, 1400"})
    void twoPeriodsAreTwo(double first, double second) {
        PeriodEstimate estimate =
                estimate(sine(720, 32, 50e-9, first * 1e-9, second * 1e-9)).orElseThrow();
        PeriodEstimate.Second other = estimate.second().orElseThrow();
        List<Double> found = List.of(estimate.period() * 1e9, other.period() * 1e9);
        // A fiftieth of the resolution of 36 um: 1300 / 28 / 50 = 0.9 nm.
        assertThat(found).anySatisfy(period -> assertThat(period).isCloseTo(first, within(1.0)));
        assertThat(found).anySatisfy(period -> assertThat(period).isCloseTo(second, within(1.0)));
    }

    @Test
    void aPeriodThatChangesIsSaidToDrift() {
        double[] heights = new double[720 * 16];
        for (int i = 0; i < heights.length; i++) {
            double x = (double) (i % 720) / 720;
            // From 1.0 um to 1.6 um in frequency over 36 um.
            heights[i] = 50e-9 * Math.cos(2 * Math.PI * 36 * (x / 1.0 + 0.5 * x * x * (1 / 1.6 - 1)));
        }
        PeriodEstimate estimate =
                estimate(new HeightMap(720, 16, 50e-9, 50e-9, heights)).orElseThrow();
        PeriodEstimate.Drift drift = estimate.drift().orElseThrow();
        // What is followed ends a period and a half before the scan does.
        assertThat(drift.first() * 1e9).isCloseTo(1000, within(60.0));
        assertThat(drift.last() * 1e9).isCloseTo(1600, within(100.0));
        assertThat(estimate.low()).isLessThanOrEqualTo(drift.first());
        assertThat(estimate.high()).isGreaterThanOrEqualTo(drift.last());
    }

    /**
     * Scans of 5 to 80 um, level and tilted, in any direction, with 0 to 15 % of disorder. The intervals are meant to hold
     * nineteen of twenty; of 25 draws fewer than 21 would come up once in thirty sets.
     */
    @ParameterizedTest
    @EnumSource
    void theTruthLiesWithinTheInterval(SimulatedGrating.Kind kind) {
        AtomicInteger tried = new AtomicInteger();
        List<String> missed = Collections.synchronizedList(new ArrayList<>());
        LongStream.range(500, 525).parallel().forEach(seed -> {
            SimulatedGrating grating = SimulatedGrating.draw(kind, seed);
            grating.estimate().ifPresent(estimate -> {
                tried.incrementAndGet();
                if (!grating.holdsTruth(estimate)) {
                    missed.add(grating.words() + ": " + estimate);
                }
            });
        });
        assertThat(tried.get()).isGreaterThanOrEqualTo(15);
        assertThat(missed).hasSizeLessThan(5);
    }

    /** In step in the middle, they fade to both sides as one wave may; a scan of less than a beat does not tell them apart. */
    @ParameterizedTest
    @ValueSource(doubles = {1030, 1040})
    void twoPeriodsOfLessThanABeatAreBothInTheInterval(double nanometres) {
        HeightMap map = Surfaces.of(
                256,
                64,
                20e-6 / 256,
                (x, y) -> 40e-9
                        * (Math.cos(2 * Math.PI * (x - 10e-6) / 1000e-9)
                                + Math.cos(2 * Math.PI * (x - 10e-6) / (nanometres * 1e-9))));
        SpectrumPeak peak = new PeriodFinder(map, false).all().peaks().get(0);
        PeriodEstimate estimate = PeriodEstimator.estimate(map, peak).orElseThrow();
        assertThat(estimate.low()).isLessThan(1000e-9);
        assertThat(estimate.high()).isGreaterThan(nanometres * 1e-9);
    }
}
