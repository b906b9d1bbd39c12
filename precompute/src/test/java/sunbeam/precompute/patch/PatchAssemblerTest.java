package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.patch.PatchSettings.DESPIKE;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;
import static sunbeam.precompute.patch.PatchSettings.PERIODIC;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError.Incidence;
import sunbeam.precompute.patch.Patch.Repetition;
import sunbeam.precompute.prepare.ScanFault;

/** Warnings about scans and about the model on their slopes. */
class PatchAssemblerTest {
    private static final int SAMPLES = 96;

    @TempDir
    Path folder;

    /** Nanometers over samples of 50 nm. */
    private Patch scan(DoubleBinaryOperator heights, Object... choices) throws IOException {
        String rows = IntStream.range(0, SAMPLES)
                .mapToObj(y -> IntStream.range(0, SAMPLES)
                        .mapToObj(x -> Double.toString(heights.applyAsDouble(x, y)))
                        .collect(Collectors.joining(" ")))
                .collect(Collectors.joining("\n"));
        Path file = Files.writeString(
                folder.resolve("scan.txt"),
                "# Channel: Height\n# Width: 4.8 um\n# Height: 4.8 um\n# Value units: nm\n" + rows + "\n");
        return PatchRequests.load(file, choices);
    }

    /** Lines 17.3 samples apart, 80 nm high, with a small waviness. */
    private static double lines(double x, double y) {
        return 40 * Math.sin(2 * Math.PI * (x + 0.05 * y) / 17.3) + 3 * Math.sin(0.7 * x * y);
    }

    private static double withDust(double x, double y) {
        return lines(x, y) + ((x == 20 && y == 30) || (x == 70 && y == 80) ? 500 : 0);
    }

    @Test
    void spikesThatMakeTheReliefHaveAWarning() throws IOException {
        assertThat(scan(PatchAssemblerTest::withDust).warnings())
                .anySatisfy(line -> assertThat(line)
                        .startsWith("2 samples are spikes, up to ")
                        .contains("despike"));
        assertThat(scan(PatchAssemblerTest::withDust, DESPIKE, "true").warnings())
                .noneMatch(line -> line.contains("are spikes"));
        assertThat(scan(PatchAssemblerTest::lines).warnings()).noneMatch(line -> line.contains("are spikes"));
    }

    @Test
    void aMarkOfMissingSamplesHasAWarning() throws IOException {
        assertThat(scan((x, y) -> (x + 7 * y) % 31 == 0 ? -9999 : lines(x, y)).warnings())
                .anyMatch(line -> line.contains("samples are -9.999 um, far from all others"));
        // Two depths of a lamellar grating.
        assertThat(scan((x, y) -> x % 16 < 2 ? -100 : 0).warnings()).noneMatch(line -> line.contains("far from"));
    }

    @Test
    void aStepAtTheBorderHasAWarningUnlessItBelongsToAPeriodOrIsBlended() throws IOException {
        assertThat(scan(PatchAssemblerTest::lines, PatchSettings.EDGES, "repeat")
                        .warnings())
                .anySatisfy(line -> assertThat(line).contains("opposite borders differ by", "(--edges blend)"));
        assertThat(scan((x, y) -> 5 * x, PERIODIC, "true").warnings()).noneMatch(line -> line.contains("borders"));
        assertThat(scan(PatchAssemblerTest::lines).warnings()).noneMatch(line -> line.contains("borders"));
    }

    @Test
    void aReliefThatLevelingRemovesHasAWarningThatNamesIt() throws IOException {
        Patch leveled = scan((x, y) -> 5 * x, LEVEL, "plane", PERIODIC, "true");
        assertThat(leveled.warnings().toString())
                .contains("is a mirror", "475 nm before levelling plane")
                .doesNotContain("unit");
    }

    @Test
    void drawnLinesAreAPieceByDefault() throws IOException {
        Patch drawn = scan((x, y) -> x);
        assertThat(drawn.repetition()).isEqualTo(Patch.Repetition.NONE);
        assertThat(drawn.warnings()).anyMatch(line -> line.contains("state it (--periodic)"));
        assertThat(scan((x, y) -> x, PERIODIC, "false").warnings()).noneMatch(line -> line.contains("--periodic"));
    }

    @Test
    void faultsNameTheirRemedyUntilTheyAreMended() throws IOException {
        DoubleBinaryOperator stopped = (x, y) -> y < 72 ? lines(x, y) + (y < 24 ? 200 : 0) : 0;
        assertThat(scan(stopped).faults())
                .extracting(ScanFault::line)
                .satisfiesExactly(
                        rows -> assertThat(rows)
                                .startsWith("rows 73 to 96 of 96")
                                .endsWith("; --crop 0:4.8um,1.2um:4.8um leaves them out"),
                        jump -> assertThat(jump)
                                .contains("between rows 24 and 25")
                                .endsWith("; --level median-rows removes this"));
        assertThat(scan(stopped, LEVEL, "median-rows").faults()).hasSize(1);
    }

    @Test
    void linesAreSyntheticWhereTheyAreTheSameAllAlongThem() {
        assertSynthetic(true, (column, row) -> column < 16 ? 1e-7 : 0);
        assertSynthetic(true, (column, row) -> 1e-7 * Math.cos(2 * Math.PI * row / 24));
        assertSynthetic(false, (column, row) -> (column < 16 ? 1e-7 : 0) + 1e-9 * Math.sin(7.0 * column * row));
        assertSynthetic(false, (column, row) -> 0);
        assertSynthetic(false, (column, row) -> row == 0 && column == 7 ? Double.NaN : 1e-9 * column);
    }

    private static void assertSynthetic(boolean synthetic, Surfaces.Samples samples) {
        assertThat(PatchAssembler.looksSynthetic(Surfaces.sampled(32, 24, 100e-9, samples)))
                .isEqualTo(synthetic);
    }

    /** Up to a quarter of the shortest wavelength, also out of a division; not along an axis with a single sample. */
    @ParameterizedTest
    @CsvSource({"2, 2, 95e-9, 95e-9", "3, 3, 95e-9, 95.00000000001e-9", "4, 1, 50e-9, 1e-6", "1, 4, 1e-6, 50e-9"})
    void isSilentAboutFinePitches(int columns, int rows, double pitchX, double pitchY) {
        assertThat(Plausibility.pitch(map(columns, rows, pitchX, pitchY))).isEmpty();
        assertThat(Plausibility.pitch(Surfaces.of(10, 10, 1e-6, (x, y) -> 0))).isEmpty();
    }

    @Test
    void namesAPitchThatIsTooCoarseAndItsAxis() {
        assertThat(Plausibility.pitch(map(2, 2, 120e-9, 50e-9)).orElseThrow())
                .contains("too coarse", "120 nm", "along x", "95 nm", "380 nm");
        assertThat(Plausibility.pitch(map(2, 2, 50e-9, 96e-9)).orElseThrow()).contains("96 nm", "along y");
    }

    /** More equal samples than a flat mirror needs. */
    @Test
    void refusesALargeFileWithoutAnyHeight() {
        HeightMap empty = Surfaces.of(2049, 2049, 50e-9, (x, y) -> 0);
        assertThatThrownBy(() -> Plausibility.requireRelief(empty, Optional.empty(), Path.of("sparse.tif")))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll(
                        "sparse.tif: all of its 2049 x 2049 samples are equal: it is empty", "export the scan again");
        empty.heights()[7] = 1e-9;
        HeightMap scan = empty.with(empty.heights());
        assertThatCode(() -> Plausibility.requireRelief(scan, Optional.empty(), Path.of("scan.tif")))
                .doesNotThrowAnyException();
    }

    private static HeightMap map(int columns, int rows, double pitchX, double pitchY) {
        double[] heights = new double[columns * rows];
        Arrays.setAll(heights, i -> 1e-9 * i);
        return new HeightMap(columns, rows, pitchX, pitchY, heights);
    }

    private static final double PITCH = 10e-9;

    private static ModelError rule(double meanSlope) {
        return new ModelError(meanSlope, 0, 0, 0);
    }

    /** Three gratings of docs/examples/coupled_waves.py, from the middle of their ranges. */
    @Test
    void theRuleHoldsForGratingsThatWereComputedRigorously() {
        // sinusoidal, metal, period 1.4195 um, depth 56.17 nm, 21.58 degrees: 0.0158.
        assertBetween(2 * 56.17e-3 / 1.4195, Incidence.NEAR_NORMAL, 0.0158);
        // blazed, metal, period 1.3454 um, depth 188.07 nm, 15.35 degrees: 0.196.
        assertBetween(2 * 188.07e-3 / 1.3454, Incidence.NEAR_NORMAL, 0.196);
        // blazed, dielectric, period 1.9533 um, depth 480.37 nm, 57.29 degrees: 0.228.
        assertBetween(2 * 480.37e-3 / 1.9533, Incidence.OBLIQUE, 0.228);
    }

    private static void assertBetween(double meanSlope, Incidence incidence, double error) {
        ModelError rule = rule(meanSlope);
        assertThat(error).isBetween(rule.low(incidence), rule.high(incidence));
    }

    @Test
    void describesSlopesBeyondTheRule() {
        assertThat(rule(1.3).describe()).contains("beyond the rule");
        assertThat(rule(0.2).describe()).contains("9.6 %").contains("mean slope 0.20;");
    }

    @Test
    void aSineHasTheSlopesOfItsFormula() {
        double steepest = 2 * Math.PI * 100e-9 / 2e-6;
        HeightMap sine = Surfaces.of(800, 10, PITCH, (x, y) -> 5e-3 + 100e-9 * Math.sin(2 * Math.PI * x / 2e-6));
        ModelError slopes = ModelError.of(sine, Repetition.PERIODIC);
        assertThat(slopes.largestSlope()).isCloseTo(steepest, within(7e-4 * steepest));
        assertThat(slopes.rmsSlope()).isCloseTo(steepest / Math.sqrt(2), within(3e-3 * steepest));
        // Twice the depth over the period; 50 samples a quarter period: 2e-3.
        assertThat(slopes.meanSlope()).isCloseTo(2 * 200e-9 / 2e-6, within(4e-4));
    }

    @Test
    void aSlopeOfExactly30DegreesIsNotSteeper() {
        assertThat(ModelError.of(Surfaces.of(50, 1, PITCH, (x, y) -> x / Math.sqrt(3)), Repetition.NONE)
                        .steepShare())
                .isZero();
        assertThat(ModelError.of(Surfaces.of(1, 1, PITCH, (x, y) -> 3e-9), Repetition.NONE))
                .isEqualTo(rule(0));
    }

    @Test
    void namesTheShareOfTheSurface() {
        // Left half flat, right half at 40 degrees: 31 of 63 steps climb.
        double rise = Math.tan(Math.toRadians(40));
        HeightMap half = Surfaces.of(64, 8, PITCH, (x, y) -> rise * Math.max(0, x - 32 * PITCH));

        assertThat(ModelError.of(half, Repetition.NONE).warning().orElseThrow())
                .contains("49.2 % of the surface", "steeper than 30 degrees");
    }

    /** 110 nm in 1.6 um: two walls in 32 steps, mean slope 0.14, for which the rule expects an error of 6 %. */
    @Test
    void lowRidgesWithSteepWallsFitTheTheory() {
        ModelError ridges = ModelError.of(
                Surfaces.of(320, 1, 50e-9, (x, y) -> (x + 1e-9) % 1.6e-6 < 0.8e-6 ? 110e-9 : 0), Repetition.NONE);
        assertThat(ridges.steepShare()).isGreaterThan(0.05);
        assertThat(ridges.expected(ModelError.Incidence.NEAR_NORMAL)).isLessThan(0.1);
        assertThat(ridges.warning()).isEmpty();
    }

    @Test
    void forgivesTheWallOfAGrating() {
        // One wall in 127 steps; the border of a scan is none.
        HeightMap wall = Surfaces.of(128, 1, PITCH, (x, y) -> x < 64 * PITCH ? 0 : 1e-6);
        assertThat(ModelError.of(wall, Repetition.NONE).warning()).isEmpty();
    }

    /** 250 nm in 2.5 um: up by its flank and down by its wall, of which a step of a flank is missing: 1 in 250. */
    @Test
    void aWallAtTheBorderOfAPeriodIsAmongItsSlopes() {
        ModelError slopes = ModelError.of(Surfaces.of(250, 1, PITCH, (x, y) -> 0.1 * x), Repetition.PERIODIC);
        assertThat(slopes.meanSlope()).isCloseTo(0.2, within(0.2 / 250 + 1e-12));
        assertThat(slopes.largestSlope()).isCloseTo(24.9, within(1e-9));
    }
}
