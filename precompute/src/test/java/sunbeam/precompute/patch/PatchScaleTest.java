package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.SettingException;

class PatchScaleTest {
    private static PatchScale scale(double width, Double extent, double maxHeight) {
        return new PatchScale(width, Optional.ofNullable(extent), maxHeight);
    }

    private static HeightImage image(int columns, int rows, SampleFormat format, double... samples) {
        return new HeightImage(columns, rows, format, "test", Arrays.copyOf(samples, columns * rows));
    }

    @ParameterizedTest
    @CsvSource({"UNSIGNED_8, 255", "UNSIGNED_16, 65535", "SIGNED_16, 65535", "FLOAT, 1"})
    void fullScaleIsMaxHeight(SampleFormat format, double fullScale) {
        HeightMap map = scale(65e-6, null, 375e-9).apply(image(2, 1, format, 0, fullScale));

        assertThat(map.at(0, 0)).isZero();
        // Two roundings: of metres per sample and of the product.
        assertThat(map.at(1, 0) / 375e-9 - 1).isBetween(-3e-16, 3e-16);
    }

    @Test
    void pixelsAreSquareWithoutAnExtent() {
        HeightMap map = scale(8e-6, null, 1e-7).apply(image(8, 4, SampleFormat.UNSIGNED_8));

        assertThat(map.pitchX()).isEqualTo(1e-6);
        assertThat(map.pitchY()).isEqualTo(1e-6);
    }

    @Test
    void anExtentMakesPixelsOblong() {
        HeightMap map = scale(8e-6, 8e-6, 1e-7).apply(image(8, 4, SampleFormat.UNSIGNED_8));

        assertThat(map.pitchX()).isEqualTo(1e-6);
        assertThat(map.pitchY()).isEqualTo(2e-6);
        assertThat(map.height()).isEqualTo(8e-6);
    }

    @Test
    void refusesScalesThatCannotBe() {
        assertThatThrownBy(() -> scale(65e-9, 65e-9, 1e-9).apply(image(4, 4, SampleFormat.UNSIGNED_8)))
                .isInstanceOf(SettingException.class)
                .hasMessageContainingAll("width is absurd", "100 nm or more");
        assertThatThrownBy(() -> scale(65e-6, 1e-6, 375e-3).apply(image(4, 4, SampleFormat.UNSIGNED_8)))
                .isInstanceOf(SettingException.class)
                .hasMessageContainingAll("max height is absurd", "the most is 1 mm");
    }

    @Test
    void refusesMicrometresTypedForNanometres() {
        assertThatThrownBy(() -> scale(65e-6, null, 375e-6).apply(image(2, 2, SampleFormat.UNSIGNED_8, 0, 255)))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("max height makes a relief of 375 um on a patch of 65 um")
                .hasMessageContaining("units");
    }

    @Test
    void refusesAPatchThatSquarePixelsMakeTooLong() {
        assertThatThrownBy(() -> scale(1e-2, null, 1e-6).apply(image(1, 11, SampleFormat.UNSIGNED_8)))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("width makes the patch 110 mm long");
    }

    @Test
    void aSingleRowMayBeNarrow() {
        HeightMap map = scale(65e-6, null, 1e-7).apply(image(1300, 1, SampleFormat.UNSIGNED_8));

        // Quotient of two roundings.
        assertThat(map.height() / 50e-9 - 1).isBetween(-5e-16, 5e-16);
    }

    @Test
    void floatImagesMayHoldMetresAndAnOffset() {
        HeightMap map = scale(65e-6, null, 1).apply(image(2, 1, SampleFormat.FLOAT, 1e-3, 1e-3 + 4e-7));

        // Heights near 1 mm are rounded to 2.2e-19 m.
        assertThat(map.relief() - 4e-7).isBetween(-3e-19, 3e-19);
    }

    @Test
    void refusesTheReliefOfAFloatImageInTheWrongUnit() {
        assertThatThrownBy(() -> scale(65e-6, null, 1).apply(image(2, 1, SampleFormat.FLOAT, 0, 375)))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("max height makes a relief of 375 m");
    }

    @Test
    void reliefOfFiveMicrometresOnABlazedPeriodIsAllowedWithAWarning() {
        PatchScale scale = scale(2.5e-6, null, 5e-6);
        HeightMap map = scale.apply(image(2, 1, SampleFormat.UNSIGNED_16, 0, 65535));

        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_16, Origin.PROGRAM))
                .singleElement()
                .asString()
                .contains("relief", "5 um", "2.5 um");
    }

    @Test
    void warnsOfAnExtentThatWasMeantAsRelief() {
        PatchScale scale = scale(65e-6, 375e-9, 375e-9);
        HeightMap map = scale.apply(image(10, 10, SampleFormat.UNSIGNED_8, 0, 255));

        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_8, Origin.PROGRAM))
                .singleElement()
                .asString()
                .contains("6.5 um apart along x", "37.5 nm along y");
    }

    @Test
    void warnsOfCoarseGreyLevels() {
        PatchScale scale = scale(65e-6, null, 5e-6);
        HeightMap map = scale.apply(image(2, 2, SampleFormat.UNSIGNED_8, 0, 255));

        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_8, Origin.PROGRAM))
                .singleElement()
                .asString()
                .contains("one grey level is 19.6078 nm");
        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_16, Origin.PROGRAM))
                .isEmpty();
    }
}
