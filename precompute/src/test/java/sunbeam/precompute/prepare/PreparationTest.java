package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
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

    private static double largest(HeightMap field) {
        return Arrays.stream(field.heights()).map(Math::abs).max().orElseThrow();
    }

    @Test
    void rowsLoseTheirOffsetsAndNothingElse() {
        HeightMap lines = field(i -> 40e-9 * Math.sin(row(i)) + rough(i % COLUMNS));
        // Rows differ by their offsets only.
        HeightMap level = Leveling.ROWS.apply(lines);
        HeightMap median = Leveling.MEDIAN_ROWS.apply(lines);
        for (int i = COLUMNS; i < level.heights().length; i++) {
            // The plane under the offsets is the same for all rows along x: rounding of 1e-8 m remains.
            assertThat(level.heights()[i]).isCloseTo(level.heights()[i - COLUMNS], within(1e-22));
            assertThat(median.heights()[i]).isCloseTo(median.heights()[i - COLUMNS], within(1e-22));
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
            assertThat(Seam.of(treated).fits()).isTrue();
        } else {
            assertThat(Seam.of(treated).ratio()).isGreaterThan(50);
        }
        for (int row = ROWS / 10; row < ROWS - ROWS / 10; row++) {
            for (int column = COLUMNS / 10; column < COLUMNS - COLUMNS / 10; column++) {
                assertThat(treated.at(column, row)).isEqualTo(slope.at(column, row));
            }
        }
    }

    @Test
    void describesStepsInOrderWithNumbers() {
        HeightMap measured = field(i -> i == 2000 ? Double.NaN : i == 500 ? 2e-6 : rough(i) + 2e-9 * (i % COLUMNS));
        Preparation.Prepared prepared = new Preparation(
                        Optional.of(new Crop(0, 3e-6, 0, 3e-6)), Leveling.PLANE, true, Edges.BLEND)
                .apply(measured);
        assertThat(prepared.steps()).hasSize(5);
        assertThat(prepared.steps().get(0)).isEqualTo("cropped from 4 um x 3 um");
        assertThat(prepared.steps().get(1)).isEqualTo("levelling plane");
        assertThat(prepared.steps().get(2)).startsWith("1 spike samples removed");
        assertThat(prepared.steps().get(3)).isEqualTo("1 missing samples filled");
        assertThat(prepared.steps().get(4)).startsWith("edges blended over 300 nm x 300 nm");
        assertThat(prepared.missing()).isEqualTo(1);
        assertThat(prepared.surface().heights()).doesNotContain(Double.NaN);
    }

    private static final String FORM =
            " is no area of four lengths; give LEFT:RIGHT,BOTTOM:TOP, such as 5um:25um,0um:10um";

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0,5um|0.5um",
                "0:0,5um,0:10um|0:0.5um,0:10um",
                "2,5 um:20um,0:1,25 um|2.5 um:20um,0:1.25 um",
            })
    void decimalCommasDifferFromThoseBetweenLengths(String written, String meant) {
        assertThatThrownBy(() -> Crop.KIND.parse(written))
                .hasMessage('"' + written + '"' + FORM + "; write a decimal point for the comma, \"" + meant + '"');
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "10um", "10,10", "5um,25um,0um,10um", "0:5um", "10x10um"})
    void tooFewLengthsAreRefusedWithTheForm(String written) {
        assertThatThrownBy(() -> Crop.KIND.parse(written)).hasMessage('"' + written + '"' + FORM);
    }

    @Test
    void anAreaMayStartAtZeroWithoutAUnit() {
        assertThat(Crop.KIND.parse("0:5um,0:2.5um")).isEqualTo(new Crop(0, 5e-6, 0, 2.5e-6));
    }
}
