package sunbeam.precompute.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class TextTest {
    private static final List<String> NAMES = List.of("Height", "Weight", "Phase", "ZSensor", "X");

    @ParameterizedTest
    @CsvSource({"Hight, Height", "heigth, Height", "PHASES, Phase", "Z Sensor, ZSensor", "wieght, Weight"})
    void aSlipOfTheFingerIsNearItsName(String written, String meant) {
        assertThat(Similar.nearest(written, NAMES)).contains(meant);
    }

    /** Two wrong letters of three or four would match any short words. */
    @ParameterizedTest
    @ValueSource(strings = {"", "Y", "red", "Topography"})
    void anotherWordIsNearNone(String written) {
        assertThat(Similar.nearest(written, NAMES)).isEmpty();
    }

    @Test
    void quotedTextIsCutAndHasNoControlCharacters() {
        assertThat(Quoted.of("a\nb\r\u001b[1m\u2028c")).isEqualTo("\"a?b??[1m?c\"");
        assertThat(Quoted.of("x".repeat(60))).isEqualTo("\"" + "x".repeat(60) + "\"");
        assertThat(Quoted.of("x".repeat(61))).isEqualTo("\"" + "x".repeat(60) + "...\"");
    }

    @Test
    void oneDegreeIsSingular() {
        assertThat(List.of(Text.wholeDegrees(0.6), Text.wholeDegrees(-1.4), Text.wholeDegrees(-0.4)))
                .containsExactly("1 degree", "-1 degree", "0 degrees");
    }
}
