package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Edges.Seam;
import sunbeam.precompute.prepare.Preparation.MissingHeights;
import sunbeam.precompute.prepare.Preparation.Spikes;

class PreparationTest {
    private static final int COLUMNS = 80;
    private static final int ROWS = 60;
    private static final double PITCH = 50e-9;

    private static HeightMap field(IntToDoubleFunction height) {
        return Surfaces.sampled(COLUMNS, ROWS, PITCH, (column, row) -> height.applyAsDouble(row * COLUMNS + column));
    }

    private static int row(int i) {
        return i / COLUMNS;
    }

    private static double rough(int i) {
        return new SplittableRandom(i).nextDouble() * 10e-9;
    }

    private static double largest(HeightMap map) {
        return Math.max(Math.abs(map.minimum()), Math.abs(map.maximum()));
    }

    @Test
    void rowsLoseTheirOffsetsAndNothingElse() {
        HeightMap lines = field(i -> 40e-9 * Math.sin(row(i)) + rough(i % COLUMNS));
        // Rows differ by their offsets only.
        for (Leveling leveling : List.of(Leveling.ROWS, Leveling.MEDIAN_ROWS)) {
            double[] level = leveling.apply(lines).heights();
            for (int i = COLUMNS; i < level.length; i++) {
                // The plane under the offsets is the same for all rows along x: rounding of 1e-8 m remains.
                assertThat(level[i]).isCloseTo(level[i - COLUMNS], within(1e-22));
            }
        }
    }

    @Test
    void aGrainOfDustDrawsTheMeanOfItsRowButNotTheMedian() {
        int dusty = 30;
        HeightMap dust = field(i -> i / COLUMNS == dusty && i % COLUMNS < 20 ? 1e-6 : rough(i));
        HeightMap mean = Leveling.ROWS.apply(dust);
        HeightMap median = Leveling.MEDIAN_ROWS.apply(dust);
        // A quarter of the row at 1 um, less the plane: the rest sinks by some 250 nm.
        assertThat(mean.at(60, dusty)).isLessThan(-200e-9);
        assertThat(median.at(60, dusty)).isBetween(-20e-9, 20e-9);
    }

    @Test
    void quadraticTakesTiltAndBow() {
        HeightMap bow = field(i ->
                1e-3 + 2e-9 * (i % COLUMNS) + 1e-12 * Math.pow(i % COLUMNS - 30, 2) - 3e-12 * (i % COLUMNS) * row(i));
        // Heights near 1 mm are doubles to 2.2e-19 m.
        assertThat(largest(Leveling.QUADRATIC.apply(bow))).isLessThan(1e-18);
        assertThat(largest(Leveling.PLANE.apply(bow))).isGreaterThan(1e-10);
    }

    @Test
    void spikesGoAndLinesStay() {
        // Lines four samples wide, whose corners and edges are no spikes, and three spikes.
        IntToDoubleFunction lines = i -> (i % COLUMNS / 4 % 2 == 0 && i / COLUMNS > 9 ? 100e-9 : 0) + 0.1 * rough(i);
        HeightMap dusty =
                field(i -> lines.applyAsDouble(i) + (i == 1234 ? 400e-9 : i == 2345 ? -300e-9 : i == 7 ? 500e-9 : 0));
        Spikes spikes = Spikes.remove(dusty);
        assertThat(spikes.count()).isEqualTo(3);
        assertThat(spikes.largest()).isCloseTo(500e-9, within(110e-9));
        for (int i : new int[] {1234, 2345, 7}) {
            assertThat(Math.abs(spikes.cleaned().heights()[i])).isLessThan(102e-9);
        }
    }

    @Test
    void theCropIsMeasuredFromTheLowerLeftCorner() {
        HeightMap numbered = field(i -> i);
        HeightMap part = Crop.KIND.parse("0.5um:1.5um,0:0.25um").apply(numbered);
        assertThat(part.columns()).isEqualTo(20);
        assertThat(part.rows()).isEqualTo(5);
        // The lowest five rows, from the tenth column on.
        assertThat(part.at(0, 4)).isEqualTo((ROWS - 1.0) * COLUMNS + 10);
        assertThat(part.at(0, 0)).isEqualTo((ROWS - 5.0) * COLUMNS + 10);
        assertThat(Crop.KIND.parse(Crop.KIND.format(new Crop(1e-6, 2e-6, 0, 3e-7))))
                .isEqualTo(new Crop(1e-6, 2e-6, 0, 3e-7));
    }

    @Test
    void areasOutsideTheScanAreRefused() {
        HeightMap scan = field(PreparationTest::rough);
        assertThatThrownBy(() -> Crop.KIND.parse("0:5um,0:1um").apply(scan))
                .hasMessageContaining("which is 4 um x 3 um");
        assertThatThrownBy(() -> Crop.KIND.parse("0:1nm,0:1nm").apply(scan)).hasMessageContaining("0 x 0 samples");
    }

    @ParameterizedTest
    @EnumSource
    void blendedEdgesGoOnWithoutAStepAndLeaveTheMiddle(Edges edges) {
        HeightMap slope = field(i -> 3e-9 * (i % COLUMNS) + 1e-9 * row(i));
        HeightMap treated = edges.apply(slope);
        if (edges == Edges.BLEND) {
            assertThat(Seam.of(treated).ratio()).isLessThan(2);
        } else {
            assertThat(Seam.of(treated).ratio()).isGreaterThan(50);
        }
        for (int row = ROWS / 6; row < treated.rows(); row++) {
            for (int column = COLUMNS / 6; column < treated.columns(); column++) {
                assertThat(treated.at(column, row)).isEqualTo(slope.at(column, row));
            }
        }
    }

    /** Else light would leave its orders for the mirror direction. */
    @Test
    void blendedEdgesOfAGratingContinueItsWaves() {
        int side = 384;
        double amplitude = 83e-9;
        HeightMap grating = Surfaces.sampled(
                side, side, PITCH, (c, r) -> amplitude * Math.sin(2 * Math.PI * (0.0283 * c + 0.012 * r)));
        HeightMap treated = Edges.BLEND.apply(grating);
        double squares = 0;
        for (int row = 0; row < treated.rows(); row++) {
            for (int column = 0; column < treated.columns(); column++) {
                squares += Math.pow(treated.at(column, row) - grating.at(column, row), 2);
            }
        }
        // Half a sample is a phase of 0.09 at the border, half of it in the mean over a tenth of each side.
        assertThat(Math.sqrt(squares / treated.heights().length)).isLessThan(0.02 * amplitude);
    }

    private static final String FORM =
            " is no area of four lengths; give LEFT:RIGHT,BOTTOM:TOP, such as 5um:25um,0um:10um";

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            0,5um|0.5um
            0:0,5um,0:10um|0:0.5um,0:10um
            2,5 um:20um,0:1,25 um|2.5 um:20um,0:1.25 um
            """)
    void decimalCommasDifferFromThoseBetweenLengths(String written, String meant) {
        assertThatThrownBy(() -> Crop.KIND.parse(written))
                .hasMessage('"' + written + '"' + FORM + "; write a decimal point for the comma, \"" + meant + '"');
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "10um", "10,10", "5um,25um,0um,10um", "0:5um", "10x10um"})
    void tooFewLengthsAreRefusedWithTheForm(String written) {
        assertThatThrownBy(() -> Crop.KIND.parse(written)).hasMessage('"' + written + '"' + FORM);
    }

    private static final double OFFSET = 1e-3;
    /** Doubles near 1 mm have steps of 2.2e-19 m, which remain after a subtraction. */
    private static final double ROUNDING_OF_OFFSET = 2.2e-19;

    private static HeightMap map(int columns, int rows, Surfaces.Samples samples) {
        return Surfaces.sampled(columns, rows, PITCH, samples);
    }

    @Test
    void meanSurvivesAnOffsetOfAMillimeter() {
        Random random = new Random(3);
        double[] relief = random.doubles(200 * 100, 0, 400e-9).toArray();
        double mean = Arrays.stream(relief).average().orElseThrow();
        HeightMap leveled = Leveling.MEAN.apply(map(200, 100, (c, r) -> OFFSET + relief[r * 200 + c]));

        for (int i = 0; i < relief.length; i++) {
            // Half a unit for rounding the height, and as much for each of the two means.
            assertThat(leveled.at(i % 200, i / 200) - (relief[i] - mean))
                    .isBetween(-2 * ROUNDING_OF_OFFSET, 2 * ROUNDING_OF_OFFSET);
        }
        // The second pass sums 2e4 values below 1e-6 m, relative rounding 1e-16 each.
        assertThat(Arrays.stream(leveled.heights()).average().orElseThrow()).isBetween(-1e-20, 1e-20);
    }

    @ParameterizedTest
    @CsvSource({"64, 48", "1, 37", "37, 1", "2, 2", "1, 2"})
    void planeRemovesATiltUnderAMillimeterOfOffset(int columns, int rows) {
        HeightMap tilted = map(columns, rows, (c, r) -> OFFSET + 3e-9 * c - 7e-9 * r);

        // Half a unit of the samples' rounding, and a few operations on 1e-7 m.
        assertThat(largest(Leveling.PLANE.apply(tilted))).isLessThan(2 * ROUNDING_OF_OFFSET);
    }

    @Test
    void planeLevelingLeavesTheRest() {
        // A product of two odd ramps has neither mean nor slope on a centered grid.
        Surfaces.Samples saddle = (c, r) -> 1e-9 * (c - 10) * (r - 7);
        HeightMap leveled = Leveling.PLANE.apply(map(21, 15, (c, r) -> saddle.at(c, r) + 5e-9 * c + 2e-9 * r));

        for (int r = 0; r < 15; r++) {
            for (int c = 0; c < 21; c++) {
                // Heights are below 3e-7 m, some ten roundings of relative 1e-16 each.
                assertThat(leveled.at(c, r) - saddle.at(c, r)).isBetween(-1e-21, 1e-21);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"MEAN", "PLANE"})
    void missingSamplesTakeNoPartAndStayMissing(Leveling leveling) {
        HeightMap map =
                map(9, 9, (c, r) -> c >= 5 && r >= 5 ? Double.NaN : 4e-9 * (leveling == Leveling.PLANE ? c : 1));
        HeightMap leveled = leveling.apply(map);

        assertThat(largest(leveled)).isLessThan(1e-22);
        assertThat(Arrays.stream(leveled.heights()).filter(Double::isNaN).count())
                .isEqualTo(16);
    }

    @Test
    void planeTakesTheSlopeAlongTheLineWhenOnlyALineIsKnown() {
        HeightMap diagonal = map(5, 5, (c, r) -> c == r ? 2e-9 * c : Double.NaN);
        assertThat(largest(Leveling.PLANE.apply(diagonal))).isLessThan(1e-23);
    }

    @ParameterizedTest
    @EnumSource
    void acceptsAMapWithoutAnySample(Leveling leveling) {
        HeightMap nothing = map(3, 3, (c, r) -> Double.NaN);

        assertThat(leveling.apply(nothing).heights()).containsOnly(Double.NaN);
    }

    private static final double NAN = Double.NaN;

    private static HeightMap map(int columns, int rows, double... heights) {
        return new HeightMap(columns, rows, 1e-9, 1e-9, heights);
    }

    /** Infinities are missing; samples of one ring do not see each other; none is seen across the edge. */
    @ParameterizedTest
    @CsvSource({
        "3, 1 2 3 4 NaN 6 7 8 9, 1 2 3 4 5 6 7 8 9",
        "4, Infinity 3 5 -Infinity, 3 3 5 5",
        "6, 0 NaN NaN NaN NaN 8, 0 0 0 8 8 8",
        "4, NaN 1 50 100, 1 1 50 100"
    })
    void holesHaveTheAverageOfTheirNeighbors(int columns, String heights, String expected) {
        double[] given = numbers(heights);
        HeightMap filled = MissingHeights.fill(map(columns, given.length / columns, given));
        assertThat(filled.heights()).containsExactly(numbers(expected));
    }

    private static double[] numbers(String text) {
        return Arrays.stream(text.split(" ", -1))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    @Test
    void fillsHolesOfAnyShapeWithoutLeavingTheRangeOfHeights() {
        Random random = new Random(5);
        double[] heights = new double[61 * 47];
        Arrays.setAll(heights, i -> random.nextInt(10) == 0 ? 1e-3 + random.nextDouble() : NAN);
        double[] filled = MissingHeights.fill(map(61, 47, heights)).heights();

        double least = Arrays.stream(heights).filter(Double::isFinite).min().orElseThrow();
        double most = Arrays.stream(heights).filter(Double::isFinite).max().orElseThrow();
        for (int i = 0; i < heights.length; i++) {
            // An average of up to eight numbers near 1 may leave their range by its rounding.
            assertThat(filled[i]).isBetween(least - 1e-15, most + 1e-15);
            assertThat(Double.isNaN(heights[i]) || filled[i] == heights[i]).isTrue();
        }
    }

    @Test
    void fillsAVeryLargeHoleFromOneSample() {
        HeightMap one = map(1000, 1000, (c, r) -> c + r == 0 ? 7 : NAN);
        assertThat(MissingHeights.fill(one).heights()).containsOnly(7);
    }

    @Test
    void refusesAMapWithoutAnySample() {
        assertThatThrownBy(() -> MissingHeights.fill(map(2, 2, NAN, NAN, NAN, NAN)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("all 4 samples are missing");
    }
}
