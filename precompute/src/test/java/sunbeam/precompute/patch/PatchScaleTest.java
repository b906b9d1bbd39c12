package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PatchScaleTest {
    private static PatchScale scale(double width, Double extent, double maxHeight) {
        return new PatchScale(
                new NamedLength("--width", width),
                Optional.ofNullable(extent).map(metres -> new NamedLength("--height", metres)),
                new NamedLength("--max-height", maxHeight));
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

    @ParameterizedTest
    @CsvSource({
        "0, 1e-6, 1e-7, --width is 0 m",
        "-65e-6, 1e-6, 1e-7, --width is -65 um",
        "NaN, 1e-6, 1e-7, --width is NaN m",
        "Infinity, 1e-6, 1e-7, --width is Infinity m",
        "65, 1e-6, 1e-7, '--width is 65 m, which is absurd'",
        "65e-9, 65e-9, 1e-9, '--width is 65 nm, which is absurd'",
        "65e-6, 0, 1e-7, --height is 0 m",
        "65e-6, -1e-6, 1e-7, --height is -1 um",
        "65e-6, 1e-6, 0, --max-height is 0 m",
        "65e-6, 1e-6, -375e-9, --max-height is -375 nm",
        "65e-6, 1e-6, NaN, --max-height is NaN m",
        "65e-6, 1e-6, 375e-3, '--max-height is 375 mm, which is absurd'",
        "65e-6, 1e-6, 1e-20, --max-height is"
    })
    void namesTheOptionAndTheValueOfAnImpossibleScale(double width, double extent, double maxHeight, String complaint) {
        assertThatThrownBy(() -> scale(width, extent, maxHeight).apply(image(4, 4, SampleFormat.UNSIGNED_8)))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining(complaint)
                .hasMessageContaining("give a length between");
    }

    @Test
    void refusesMicrometresTypedForNanometres() {
        assertThatThrownBy(() -> scale(65e-6, null, 375e-6).apply(image(2, 2, SampleFormat.UNSIGNED_8, 0, 255)))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("--max-height of 375 um")
                .hasMessageContaining("65 um")
                .hasMessageContaining("units");
    }

    @Test
    void refusesAPatchThatSquarePixelsMakeTooLong() {
        assertThatThrownBy(() -> scale(1e-2, null, 1e-6).apply(image(1, 11, SampleFormat.UNSIGNED_8)))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("--width is 10 mm")
                .hasMessageContaining("110 mm");
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
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("--max-height of 1 m")
                .hasMessageContaining("relief of 375 m");
    }

    @Test
    void reliefOfFiveMicrometresOnABlazedPeriodIsAllowedWithAWarning() {
        PatchScale scale = scale(2.5e-6, null, 5e-6);
        HeightMap map = scale.apply(image(2, 1, SampleFormat.UNSIGNED_16, 0, 65535));

        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_16))
                .singleElement()
                .asString()
                .contains("relief", "5 um", "2.5 um");
    }

    @Test
    void warnsOfAnExtentThatWasMeantAsRelief() {
        PatchScale scale = scale(65e-6, 375e-9, 375e-9);
        HeightMap map = scale.apply(image(10, 10, SampleFormat.UNSIGNED_8, 0, 255));

        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_8))
                .singleElement()
                .asString()
                .contains("6.5 um apart along x", "37.5 nm along y");
    }

    @Test
    void warnsOfCoarseGreyLevels() {
        PatchScale scale = scale(65e-6, null, 5e-6);
        HeightMap map = scale.apply(image(2, 2, SampleFormat.UNSIGNED_8, 0, 255));

        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_8))
                .singleElement()
                .asString()
                .contains("one grey level is 19.6078 nm");
        assertThat(scale.warnings(map, SampleFormat.UNSIGNED_16)).isEmpty();
    }
}
