package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.fault.ScanFaults;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.prepare.HeightField;
import sunbeam.precompute.prepare.Levelling;

/** Sound scans of which something wrong was said, as an outsider found. 256 x 256 samples of 10 um. */
final class MisleadingScansTest {
    private static final int SAMPLES = 256;
    private static final double WIDTH = 10e-6;
    private static final double PITCH = WIDTH / SAMPLES;

    private static HeightMap scan(DoubleBinaryOperator height) {
        SplittableRandom noise = new SplittableRandom(5);
        return Surfaces.of(SAMPLES, SAMPLES, PITCH, (x, y) -> height.applyAsDouble(x, y) + 1e-9 * noise.nextGaussian());
    }

    private static double lines(double x, double period, double duty) {
        double turns = x / period;
        return turns - Math.floor(turns) < duty ? 60e-9 : 0;
    }

    private static double along(double x, double y, double degrees) {
        return x * Math.cos(Math.toRadians(degrees)) + y * Math.sin(Math.toRadians(degrees));
    }

    private static Optional<String> refusal(HeightMap map) {
        SpectrumPeak peak = new PeriodFinder(map, false).all().peaks().get(0);
        return PeriodJudgement.refusal(List.of(), PeriodEstimator.estimate(map, peak), peak);
    }

    /** 934 nm, 95 % 878 to 988, was told of the first. */
    @ParameterizedTest
    @CsvSource({"150, 0", "170, 0", "150, 20", "170, 20", "130, 20"})
    void whatSamplingLeavesOfFineLinesIsNoPeriod(double nanometres, double degrees) {
        assertThat(refusal(scan((x, y) -> lines(along(x, y, degrees), nanometres * 1e-9, 0.4))))
                .hasValueSatisfying(why -> assertThat(why).contains("what sampling has made of finer lines"));
    }

    /** Beside fine pillars that hold a third of the heights, a wave of its own is told. */
    @Test
    void aGratingBesideFineLinesIsTold() {
        HeightMap map = scan((x, y) ->
                lines(along(x, y, 30), 900e-9, 0.5) + 40e-9 * Math.sin(2 * Math.PI * along(x, y, 100) / 160e-9));
        SpectrumPeak peak = new PeriodFinder(map, false).all().peaks().get(0);
        PeriodEstimate told = PeriodEstimator.estimate(map, peak).orElseThrow();
        assertThat(told.doubt()).isEqualTo(PeriodEstimate.Doubt.NONE);
        assertThat(900e-9).isBetween(told.low(), told.high());
    }

    /** 1600 nm with 12 slips was told of 1131 nm. */
    @ParameterizedTest
    @CsvSource({"800, 800", "900, 900", "600, 600", "800, 500"})
    void hardSquaresAreLattices(double width, double height) {
        HeightMap map = scan((x, y) ->
                ((long) Math.floor(x / (width * 1e-9) + 0.1) + (long) Math.floor(y / (height * 1e-9) + 0.2)) % 2 == 0
                        ? 60e-9
                        : 0);
        SpectrumPeak peak = new PeriodFinder(map, false).all().peaks().get(0);
        PeriodEstimate told = PeriodEstimator.estimate(map, peak).orElseThrow();
        double truth = 2e-9 * width * height / Math.hypot(width, height);
        assertThat(truth).isBetween(told.low(), told.high());
        assertThat(told.halfWidth()).isLessThan(0.05 * truth);
    }

    /** Their periods were told to a thousandth, and wrong. */
    @ParameterizedTest
    @ValueSource(doubles = {87, 88.5})
    void linesAlongRowsThatWereLevelledOneByOneAreNotTold(double degrees) {
        HeightMap map = scan((x, y) -> lines(along(x, y, degrees), 700e-9, 0.4));
        assertThat(refusal(map)).isEmpty();
        assertThat(refusal(map.levelled(Levelling.MEDIAN_ROWS))).isPresent();
        assertThat(refusal(map.levelled(Levelling.ROWS))).isPresent();
    }

    /** 12, 31 and 17 nm between the last rows were faults, and levelling rows took the grating away. */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.35, 0.6, 0.9})
    void linesAlongTheRowsDoNotJumpAtABorder(double phase) {
        HeightMap rows = scan((x, y) -> lines(y + phase * 750e-9, 750e-9, 0.3));
        HeightMap crossed = scan((x, y) -> lines(x, 900e-9, 0.4) + 0.5 * lines(y + phase * 750e-9, 750e-9, 0.3));
        for (HeightMap map : List.of(rows, crossed)) {
            HeightField field = new HeightField(SAMPLES, SAMPLES, PITCH, PITCH, map.toArray());
            assertThat(ScanFaults.in(field, Optional.empty())).isEmpty();
        }
    }

    /** "Too few of these periods fit" was said, as the slip had turned the peak beyond the direction whose opposite parts show. */
    @ParameterizedTest
    @ValueSource(doubles = {-4, -3, -1, 0, 1, 3, 4})
    void oneSlipOfNearlyVerticalLinesIsFollowed(double degrees) {
        HeightMap map = scan((x, y) ->
                60e-9 * Math.cos(2 * Math.PI * along(y < -0.6 * WIDTH ? x + 380e-9 : x, y, degrees) / 950e-9));
        SpectrumPeak peak = new PeriodFinder(map, false).all().peaks().get(0);
        PeriodEstimate told = PeriodEstimator.estimate(map, peak).orElseThrow();
        assertThat(told.slips()).hasSize(1);
        assertThat(950e-9).isBetween(told.low(), told.high());
        // Noise of a sixtieth.
        assertThat(told.halfWidth()).isLessThan(0.01 * told.period());
    }

    /** A wave of 1.8 um was "seen 5.9 times" in the beat of 157 nm with the samples. */
    @Test
    void fineWavesAreNotSeenAFewTimes() {
        assertThat(FewPeriods.in(scan((x, y) -> 60e-9 * Math.sin(2 * Math.PI * along(x, y, 23) / 157.013e-9))))
                .isEmpty();
        assertThat(FewPeriods.in(scan(
                        (x, y) -> 15e-9 * Math.sin(2 * Math.PI * 0.0731 * (x / PITCH + SAMPLES * (y / PITCH))))))
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"256, 1", "1, 256", "256, 2", "2, 256", "256, 3"})
    void fewRowsAreNoError(int columns, int rows) {
        HeightMap map = Surfaces.of(columns, rows, PITCH, (x, y) -> lines(x + y, 873e-9, 0.5));
        assertThatCode(() ->
                        new PeriodFinder(map, false).all().peaks().forEach(peak -> PeriodEstimator.estimate(map, peak)))
                .doesNotThrowAnyException();
    }

    /** "Rows 1 to 256 are missing" was said of it. */
    @Test
    void samplesThatAreMissingHereAndThereStopNoRow() {
        SplittableRandom random = new SplittableRandom(12);
        double[] heights = scan((x, y) -> lines(along(x, y, 11), 873e-9, 0.5)).toArray();
        for (int i = 0; i < heights.length; i++) {
            heights[i] = random.nextDouble() < 0.6 ? Double.NaN : heights[i];
        }
        HeightField field = new HeightField(SAMPLES, SAMPLES, PITCH, PITCH, heights);
        assertThat(ScanFaults.in(field, Optional.empty())).isEmpty();
    }
}
