package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;

class ScanFaultsTest {
    private static final int COLUMNS = 120;
    private static final int ROWS = 96;
    private static final double PITCH = 80e-9;

    /** A faultless scan: a tilted, oblique sine of 900 nm with noise. */
    private static double[] scan(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        return heights((x, y) ->
                40e-9 * Math.sin(2 * Math.PI * (x + 0.2 * y) / 900e-9) + 0.01 * y + 2e-9 * random.nextGaussian());
    }

    private static double[] heights(DoubleBinaryOperator height) {
        return Surfaces.sampled(
                        COLUMNS,
                        ROWS,
                        PITCH,
                        (column, row) -> height.applyAsDouble(column * PITCH, (ROWS - row) * PITCH))
                .heights();
    }

    private static HeightMap field(double[] heights) {
        return new HeightMap(COLUMNS, ROWS, PITCH, PITCH, heights);
    }

    private static List<ScanFault> faults(double[] heights) {
        return ScanFaults.in(field(heights), Optional.empty());
    }

    private static List<String> words(double[] heights) {
        return faults(heights).stream().map(ScanFault::words).toList();
    }

    private static double[] rounded(double[] heights, int levels) {
        double lowest = Arrays.stream(heights).min().orElseThrow();
        double step = (Arrays.stream(heights).max().orElseThrow() - lowest) / (levels - 1);
        return Arrays.stream(heights)
                .map(height -> lowest + step * Math.rint((height - lowest) / step))
                .toArray();
    }

    private static void copyRow(double[] heights, int from, int to) {
        System.arraycopy(heights, from * COLUMNS, heights, to * COLUMNS, COLUMNS);
    }

    private static void shiftRow(double[] heights, int row, double by) {
        for (int i = row * COLUMNS; i < (row + 1) * COLUMNS; i++) {
            heights[i] += by;
        }
    }

    @Test
    void aSoundScanHasNoFault() {
        assertThat(faults(scan(1))).isEmpty();
        assertThat(faults(rounded(scan(2), 256))).isEmpty();
        assertThat(faults(rounded(scan(3), 12))).isEmpty();
    }

    @Test
    void aStuckLineIsNamedWithThePartThatIsFreeOfIt() {
        double[] heights = scan(1);
        copyRow(heights, 29, 30);
        copyRow(heights, 29, 31);
        assertThat(words(heights))
                .singleElement()
                .asString()
                .startsWith("rows 31 to 32 of 96 (from the top) hold no measurement");
        Crop part = faults(heights).get(0).part().orElseThrow();
        assertThat(part.samples(field(heights))).isEqualTo(new Crop.Samples(0, COLUMNS, 32, ROWS));
        // The crop as typed by a user selects the same rows.
        Crop typed = Crop.KIND.parse(part.written());
        assertThat(typed.samples(field(heights))).isEqualTo(new Crop.Samples(0, COLUMNS, 32, ROWS));
        assertThat(part.written()).isEqualTo("0:9.6um,0:5.12um");
    }

    @Test
    void rowsOfACroppedScanAreCountedInTheWholeOfIt() {
        double[] heights = scan(1);
        copyRow(heights, 29, 30);
        copyRow(heights, 29, 31);
        Crop crop = new Crop(8 * PITCH, 100 * PITCH, 10 * PITCH, 80 * PITCH);
        ScanFault fault = ScanFaults.in(field(heights), Optional.of(crop)).get(0);
        assertThat(fault.words()).startsWith("rows 31 to 32 of 96");
        assertThat(fault.part().orElseThrow().samples(field(heights))).isEqualTo(new Crop.Samples(8, 100, 32, 86));
        Crop below = new Crop(0, COLUMNS * PITCH, 0, 40 * PITCH);
        assertThat(ScanFaults.in(field(heights), Optional.of(below))).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, Double.NaN, 3e-6})
    void aScanThatWasStoppedIsCutWhereItEnds(double rest) {
        double[] heights = scan(4);
        Arrays.fill(heights, 70 * COLUMNS, ROWS * COLUMNS, rest);
        assertThat(words(heights)).singleElement().asString().contains("71 to 96", "no measurement");
        assertThat(faults(heights).get(0).part().orElseThrow().samples(field(heights)))
                .isEqualTo(new Crop.Samples(0, COLUMNS, 0, 70));
    }

    /** Instruments fill the missing rows with the last line, and programs level them with the rest. */
    @Test
    void theLastLineOverAndOverIsAScanThatWasStopped() {
        double[] heights = scan(5);
        for (int row = 70; row < ROWS; row++) {
            copyRow(heights, 69, row);
        }
        double[] leveled = Leveling.PLANE.apply(field(heights)).heights();
        for (double[] each : List.of(heights, leveled)) {
            assertThat(words(each)).singleElement().asString().contains("71 to 96", "no measurement");
        }
    }

    private static double ridge(double turns) {
        return turns - Math.floor(turns) < 0.5 ? 1 : 0;
    }

    /** Lines with a profile over turns, whose frequency has a direction. */
    private static DoubleBinaryOperator lines(DoubleUnaryOperator profile, double cosine, double sine) {
        return (x, y) -> 80e-9 * profile.applyAsDouble((x * cosine + y * sine) / 960e-9);
    }

    /** Generated surfaces with equal or flat rows: lines, sines, a saw, trapezoids, soft walls, half sines, squares, an egg box. */
    private static Stream<DoubleBinaryOperator> drawn() {
        return Stream.of(
                lines(ScanFaultsTest::ridge, 1, 0),
                lines(ScanFaultsTest::ridge, 0, 1),
                lines(t -> Math.cos(2 * Math.PI * t), 0, 1),
                lines(ScanFaultsTest::ridge, 1, 0.96),
                lines(t -> t - Math.floor(t), 0.6, 0.8),
                lines(t -> Math.max(-0.5, Math.min(0.5, 3 * Math.abs(t - Math.floor(t) - 0.5) - 0.75)), 1, 0.2),
                lines(t -> Math.tanh(8 * Math.cos(2 * Math.PI * t)), 1, 0.1),
                lines(t -> Math.max(0, Math.cos(2 * Math.PI * t)), 1, 0),
                (x, y) -> ridge(x / 1e-6) * ridge(y / 1.5e-6) * 1e-7,
                (x, y) -> 5e-8 * Math.cos(2 * Math.PI * x / 1e-6) * Math.cos(2 * Math.PI * y / 1.6e-6));
    }

    /** Rows of a computed surface that is constant along x or y equal each other but for defects: they are its measurement. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1"})
    void linesWithoutNoiseAreMeasured(double alongX, double alongY) {
        double[] heights = heights(
                (x, y) -> 60e-9 * Math.sin(2 * Math.PI * (alongX * x + alongY * y) / 900e-9) + 0.002 * alongX * y);
        // Dust in the lower half leaves the upper one without a difference.
        for (int row = ROWS / 2; row < ROWS; row++) {
            heights[row * COLUMNS + row % COLUMNS] += 300e-9;
        }
        assertThat(words(heights)).noneMatch(line -> line.contains("no measurement"));
    }

    /** Without noise, and with noise of a third of a level on flat tops, as in 8-bit pictures of real gratings. */
    @ParameterizedTest
    @MethodSource("drawn")
    void aDrawnPatternHasNoFault(DoubleBinaryOperator drawn) {
        SplittableRandom random = new SplittableRandom(7);
        for (double noise : new double[] {0, 1e-10, 2e-9}) {
            double[] heights = Arrays.stream(heights(drawn))
                    .map(height -> height + noise * random.nextGaussian())
                    .toArray();
            assertThat(faults(heights)).isEmpty();
            assertThat(faults(rounded(heights, 256))).isEmpty();
        }
    }

    @Test
    void rowsWithOffsetsAreLevelledByTheirMedians() {
        SplittableRandom random = new SplittableRandom(9);
        double[] heights = scan(10);
        for (int row = 0; row < ROWS; row++) {
            shiftRow(heights, row, 6e-9 * random.nextGaussian());
        }
        assertThat(faults(heights)).singleElement().satisfies(fault -> {
            assertThat(fault.words()).startsWith("rows have offsets of ");
            assertThat(fault.leveling()).contains(Leveling.MEDIAN_ROWS);
        });
        assertThat(faults(Leveling.MEDIAN_ROWS.apply(field(heights)).heights())).isEmpty();
    }

    /** 30 rows of a grating, whose lines run across or along the rows, and of noise, lie ten times its amplitude higher or lower. */
    @ParameterizedTest
    @CsvSource({"1, 0, 4e-7", "0, 1, -4e-7", "0, 0, 4e-7"})
    void aBlockOfShiftedRowsIsAFault(double alongX, double alongY, double shift) {
        SplittableRandom random = new SplittableRandom(13);
        double[] heights = heights((x, y) ->
                40e-9 * Math.sin(2 * Math.PI * (alongX * x + alongY * y) / 900e-9) + 2e-9 * random.nextGaussian());
        for (int row = 40; row < 70; row++) {
            shiftRow(heights, row, shift);
        }
        assertThat(faults(heights)).singleElement().satisfies(fault -> {
            assertThat(fault.words())
                    .startsWith("rows 41 to 70 of 96 (from the top) lie ")
                    .contains(shift > 0 ? "higher" : "lower");
            assertThat(fault.leveling()).contains(Leveling.MEDIAN_ROWS);
        });
        // Two ridges along the rows belong to the surface.
        for (int row = 10; row < 25; row++) {
            shiftRow(heights, row, shift);
        }
        assertThat(faults(heights)).isEmpty();
    }

    /** A sideways shift of the lines is another fault. */
    @Test
    void aSlipSidewaysIsNoJumpInHeight() {
        SplittableRandom random = new SplittableRandom(12);
        double[] saw = heights((x, y) -> {
            double turns = x / 2640e-9 + (y > 4e-6 ? 0.2 : 0);
            return 2e-7 * (turns - Math.floor(turns)) + 2e-9 * random.nextGaussian();
        });
        assertThat(faults(saw)).isEmpty();
    }

    /** Leveling of rows removes lines along the rows: 8.5 of them; offsets of noise, and a jump, are no lines. */
    @Test
    void aWaveInTheRowsIsTold() {
        SplittableRandom random = new SplittableRandom(14);
        double[] lines = heights((x, y) -> 40e-9 * Math.sin(2 * Math.PI * y / 900e-9) + 2e-9 * random.nextGaussian());
        double[] across = scan(15);
        for (int row = 0; row < ROWS; row++) {
            shiftRow(lines, row, row > 50 ? 3e-7 : 0);
            shiftRow(across, row, 6e-9 * random.nextGaussian() + (row > 50 ? 3e-7 : 0));
        }
        // Half of a line over the scan.
        assertThat(RowWave.period(field(lines)).orElseThrow()).isBetween(850e-9, 950e-9);
        assertThat(RowWave.period(field(across))).isEmpty();
    }

    @Test
    void fewSamplesAreNotJudged() {
        HeightMap few = new HeightMap(3, 2, PITCH, PITCH, new double[6]);
        assertThat(ScanFaults.in(few, Optional.empty())).isEmpty();
    }

    /** Lines along the rows have offsets, too, but change them smoothly; along the columns, a block is relief of the surface. */
    @ParameterizedTest
    @ValueSource(doubles = {60e-9, 100e-9, 200e-9})
    void aBlockOfRowsIsToldBesideLinesAlongTheRows(double shift) {
        SplittableRandom random = new SplittableRandom(4);
        double[] lines = heights((x, y) -> 50e-9 * Math.sin(2 * Math.PI * y / 1e-6) + 3e-9 * random.nextGaussian());
        double[] block = lines.clone();
        Arrays.setAll(block, i -> lines[i] + (i / COLUMNS >= 40 && i / COLUMNS < 60 ? shift : 0));
        assertThat(words(block))
                .singleElement()
                .asString()
                .matches("rows 41 to 60 of 96 .* lie .* higher than the others.*");
        double[] ridge = lines.clone();
        Arrays.setAll(ridge, i -> lines[i] + (i % COLUMNS >= 40 && i % COLUMNS < 60 ? shift : 0));
        assertThat(words(ridge)).isEmpty();
        double[] pure = heights((x, y) -> 50e-9 * Math.sin(2 * Math.PI * y / 1e-6) + (x > 5e-6 ? shift : 0));
        assertThat(words(pure)).isEmpty();
    }
}
