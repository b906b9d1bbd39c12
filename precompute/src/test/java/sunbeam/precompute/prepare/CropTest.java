package sunbeam.precompute.prepare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Refusals of areas. */
final class CropTest {
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
