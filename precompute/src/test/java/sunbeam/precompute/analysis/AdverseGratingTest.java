package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.prepare.Levelling;

/** Gratings that once had an answer stated with confidence and wrong. */
class AdverseGratingTest {
    private static HeightMap scan(int columns, int rows, double pitch, DoubleBinaryOperator height) {
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            int row = i / columns;
            heights[i] = height.applyAsDouble((i % columns - 0.5 * columns) * pitch, (0.5 * rows - row) * pitch);
        }
        return new HeightMap(columns, rows, pitch, pitch, heights).levelled(Levelling.PLANE);
    }

    private static double part(double turns) {
        return turns - Math.floor(turns);
    }

    /** Ridges as wide as the gaps between them, with walls of a fiftieth of a period. */
    private static double ridge(double turns) {
        return 1 / (1 + Math.exp((Math.abs(part(turns) - 0.5) - 0.25) / 0.02));
    }

    private static Periodicity periods(HeightMap map) {
        return new PeriodFinder(map, false).all();
    }

    private static PeriodEstimate estimate(HeightMap map) {
        return PeriodEstimator.estimate(map, periods(map).peaks().get(0)).orElseThrow();
    }

    /** A bow's slope, which grows from end to end, drew 1084 nm to 1087.1 nm, 95 % 1087.0 to 1087.1 nm. */
    @Test
    void aScannersBowDoesNotMoveThePeriod() {
        double width = 454 * 55.3e-9;
        PeriodEstimate estimate = estimate(scan(
                454, 60, 55.3e-9, (x, y) -> 60e-9 * ridge(x / 1084.4e-9 + 0.2) + 4e-6 * x * x / (width * width)));
        assertThat(1084.4e-9).isBetween(estimate.low(), estimate.high());
        // The interval is the sampling's: a wall's overtones beat with the wave.
        assertThat(estimate.halfWidth()).isLessThan(0.01 * 1084e-9);
        assertThat(estimate.period()).isCloseTo(1084.4e-9, within(0.5e-9));
    }

    /** Sampled 15.1 times a period, a saw's 14th overtone comes back beside the wave and draws it to 15 samples. */
    @ParameterizedTest
    @CsvSource({"143, 259.44, 3920, 0.0", "143, 259.44, 3920, 0.3", "400, 100, 1510, 0.6"})
    void wallsBetweenSamplesBeatWithTheWave(int columns, double pitchNm, double periodNm, double start) {
        PeriodEstimate estimate =
                estimate(scan(columns, 40, pitchNm * 1e-9, (x, y) -> 1e-7 * part(x / (periodNm * 1e-9) + start)));
        assertThat(periodNm * 1e-9).isBetween(estimate.low(), estimate.high());
    }

    /** The interval of a wave without walls stays as narrow as the scan allows: no overtone comes back. */
    @Test
    void aSineHasNoBeat() {
        HeightMap sine = scan(143, 40, 259.44e-9, (x, y) -> 1e-7 * Math.sin(2 * Math.PI * x / 3920e-9));
        assertThat(SamplingBeat.error(sine, 1 / 3920e-9, 0, 30e-6)).isLessThan(1e-4 / 30e-6);
    }

    /** Waviness hid the first order of ridges, and their third was taken for the period. */
    @Test
    void anOvertoneIsNotThePeriod() {
        HeightMap map = scan(
                240,
                131,
                144.4e-9,
                (x, y) -> 100e-9 * ridge(x / 1923e-9)
                        + 90e-9 * Math.cos(2 * Math.PI * (0.07e6 * x + 0.03e6 * y) + 1)
                        + 70e-9 * Math.cos(2 * Math.PI * (-0.02e6 * x + 0.09e6 * y) + 2));
        PeriodEstimate estimate = estimate(map);
        assertThat(1923e-9).isBetween(estimate.low(), estimate.high());
        assertThat(estimate.period()).isCloseTo(1923e-9, within(10e-9));
    }

    /** A step of 200 nm hid the first order of a saw, and its seventh, come back by the sampling, was "177 nm". */
    @Test
    void aStepDoesNotHideTheFirstOrder() {
        HeightMap map = scan(
                256,
                256,
                78.1e-9,
                (x, y) -> 80e-9 * part((0.966 * x - 0.259 * y) / 900e-9) + (x - 0.2 * y > 1e-6 ? 200e-9 : 0));
        PeriodEstimate estimate = estimate(map);
        assertThat(estimate.period()).isCloseTo(900e-9 / Math.hypot(0.966, 0.259), within(5e-9));
        assertThat(900e-9).isBetween(estimate.low(), estimate.high());
    }

    /** With 2.4 samples a period, the wave's mirror image was "a second period": the surface had none. */
    @Test
    void fewSamplesAPeriodAreNoSecondPeriod() {
        PeriodEstimate estimate = estimate(scan(64, 64, 625e-9, (x, y) -> 4e-8 * Math.sin(2 * Math.PI * x / 1500e-9)));
        assertThat(estimate.second()).isEmpty();
        assertThat(1500e-9).isBetween(estimate.low(), estimate.high());
    }

    /** Ridges in pairs repeat after two of their distances, and that is told beside it. */
    @Test
    void pairsOfLinesShowBothDistances() {
        HeightMap map = scan(
                394,
                60,
                80.5e-9,
                (x, y) -> 1e-7 * Math.exp(-Math.pow((part(x / 848e-9) - 0.3) / 0.08, 2))
                        + 0.7e-7 * Math.exp(-Math.pow((part(x / 848e-9) - 0.7) / 0.1, 2)));
        assertThat(periods(map).peaks())
                .anySatisfy(peak -> assertThat(peak.period()).isCloseTo(424e-9, within(1e-9)));
        // To a tenth of a bin of 37 periods.
        assertThat(periods(map).peaks())
                .anySatisfy(peak -> assertThat(peak.period()).isCloseTo(848e-9, within(3e-9)));
    }

    /** Where the middle of eight lines is broken away, two waves fit as well as one, and neither is the truth. */
    @Test
    void fewBrokenLinesAreNotTwoPeriods() {
        for (int missing = -3; missing < 3; missing++) {
            int gap = missing;
            HeightMap map = scan(111, 46, 79.3e-9, (x, y) -> {
                double line = Math.floor(x / 1122e-9);
                return line == gap || line == gap + 1
                        ? 0
                        : 1e-7 * Math.exp(-Math.pow((part(x / 1122e-9) - 0.5) / 0.15, 2));
            });
            for (SpectrumPeak peak : periods(map).peaks()) {
                PeriodEstimator.estimate(map, peak)
                        .filter(told -> Math.abs(told.period() / 1122e-9 - 1) < 0.3)
                        .ifPresent(told -> assertThat(1122e-9).isBetween(told.low(), told.high()));
            }
        }
    }

    /** Along the mean direction bent lines seem farther apart, here by 0.2 %. */
    @Test
    void bentLinesAreCloserThanAlongTheirMeanDirection() {
        PeriodEstimate estimate = estimate(scan(
                304, 229, 96.7e-9, (x, y) -> 0.5e-7 * Math.cos(2 * Math.PI * Math.hypot(x + 58.8e-6, y) / 1823e-9)));
        assertThat(1823e-9).isBetween(estimate.low(), estimate.high());
        assertThat(estimate.halfWidth()).isLessThan(0.01 * 1823e-9);
    }

    /** "20 um, 79 % of the variance" was said of a scan of 20 um that is no period of its surface. */
    @Test
    void wavinessIsNoPeriodOfAPiece() {
        HeightMap map = scan(128, 128, 156e-9, (x, y) -> 1e-8 * Math.cos(2 * Math.PI * y / 20e-6 + 0.4));
        assertThat(new PeriodFinder(map, true).all().found()).isTrue();
        assertThat(periods(map).found()).isFalse();
    }

    /** Slips at one row or two drew 1000 nm to 1001.08 nm, 95 % 1000.73 to 1001.28 nm, and made two periods of one. */
    @ParameterizedTest
    @EnumSource(names = {"SLIPPED", "SLIPPED_TWICE", "ROWS_LOST"})
    void aSlipDoesNotMoveThePeriod(FaultyScan.Kind kind) {
        int told = 0;
        for (long seed = 0; seed < 12; seed++) {
            FaultyScan scan = FaultyScan.draw(kind, seed);
            Optional<PeriodEstimate> answer = scan.estimate();
            told += answer.isPresent() ? 1 : 0;
            answer.ifPresent(estimate -> assertThat(scan.holdsTruth(estimate))
                    .as(scan.words() + estimate)
                    .isTrue());
        }
        // Where slips leave pieces of too few periods, nothing is told: of two slips in a third of them.
        assertThat(told).isGreaterThan(6);
    }

    /** A grating has no slip, nor one whose lines stray or whose gaps deviate. */
    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "ROWS")
    void aGratingDoesNotSlip(SimulatedGrating.Kind kind) {
        int slipped = 0;
        for (long seed = 0; seed < 8; seed++) {
            slipped += SimulatedGrating.draw(kind, seed)
                            .estimate()
                            .filter(estimate -> !estimate.slips().isEmpty())
                            .isPresent()
                    ? 1
                    : 0;
        }
        // Of 30 each of the runs' seeds none or one.
        assertThat(slipped).isLessThanOrEqualTo(1);
    }

    /** 187 nm, 95 % 186.7 to 188.0, was told of terraces 2.4 um wide: a staircase of samples. */
    @Test
    void terracesHaveNoPeriodOfSomeSamples() {
        for (long seed : new long[] {3006, 3013, 3018}) {
            assertThat(FaultyScan.draw(FaultyScan.Kind.TERRACES, seed).estimate())
                    .isEmpty();
        }
    }

    /** Its wave comes and goes, as chance's does, but no other wave is beside it. */
    @Test
    void aGratingOnPartOfAScanIsNoChance() {
        PeriodEstimate estimate =
                estimate(scan(300, 80, 80e-9, (x, y) -> x > 0 ? 1e-7 * (ridge(x / 1100e-9) - 0.5) : 0));
        assertThat(estimate.doubt()).isEqualTo(PeriodEstimate.Doubt.NONE);
        assertThat(1100e-9).isBetween(estimate.low(), estimate.high());
    }

    /** Its first wave becomes one of two rows a period, and its second was told: 450 nm, 95 % 449.8 to 450.4. */
    @ParameterizedTest
    @CsvSource({"20", "60", "90"})
    void everySecondRowShiftedByHalfAPeriodIsSaid(double degrees) {
        double cosine = Math.cos(Math.toRadians(degrees));
        double sine = Math.sin(Math.toRadians(degrees));
        HeightMap map = scan(
                160,
                160,
                40e-9,
                (x, y) -> 5e-8 * part((x * cosine + y * sine) / 900e-9 + 0.5 * (Math.rint(y / 40e-9) % 2)));
        SpectrumPeak peak = periods(map).peaks().get(0);
        assertThat(PeriodJudgement.refusal(List.of(), PeriodEstimator.estimate(map, peak), peak))
                .hasValueSatisfying(why -> assertThat(why)
                        // Walls between samples move that of 22.5 samples by up to 1 %.
                        .containsPattern("shifted by half of a period of about (89|90). nm"));
    }

    /** Three rows a period look like their own half with every second row turned. */
    @Test
    void threeRowsAPeriodAreNotShifted() {
        PeriodEstimate estimate = estimate(scan(64, 96, 300e-9, (x, y) -> 5e-8 * Math.sin(2 * Math.PI * y / 900e-9)));
        assertThat(estimate.doubt()).isEqualTo(PeriodEstimate.Doubt.NONE);
        assertThat(900e-9).isBetween(estimate.low(), estimate.high());
    }

    /** A tip with two ends draws each ridge twice: the third and second parts of 1000 nm, 333 and 500, were told as two periods. */
    @Test
    void twoOvertonesHaveOneFundamental() {
        HeightMap map = scan(
                300,
                60,
                40e-9,
                (x, y) -> 6e-8
                        * Math.max(
                                part(x / 1000e-9 + 0.21) < 0.2 ? 1 : 0,
                                part((x - 380e-9) / 1000e-9 + 0.21) < 0.2 ? 0.7 : 0));
        PeriodEstimate estimate = estimate(map);
        assertThat(1000e-9).isBetween(estimate.low(), estimate.high());
        assertThat(estimate.second()).isEmpty();
    }
}
