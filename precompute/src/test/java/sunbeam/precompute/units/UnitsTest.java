package sunbeam.precompute.units;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.text.Text;

/** Lengths, angles and other words as users write and read them. */
class UnitsTest {
    @ParameterizedTest
    @CsvSource({
        "65um, 65e-6",
        "65 um, 65e-6",
        "65 \u00b5m, 65e-6",
        "65\u03bcm, 65e-6",
        "818.69 nm, 818.69e-9",
        "2.5e-6 m, 2.5e-6",
        "1mm, 1e-3",
        "0.3 m, 0.3",
        ".5 cm, 0.005",
        "12 pm, 12e-12",
        "'  1E3  nm ', 1e-6",
        "-5nm, -5e-9",
        "0 um, 0"
    })
    void readsANumberWithItsUnitToTheNearestDouble(String text, double meters) {
        assertThat(Lengths.parse(text)).isEqualTo(meters);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', emptyValue = "", textBlock = """
            65         | has no unit
            ' 2.5e-6 ' | has no unit
            65 inch    | pm, nm, um, mm, cm or m
            65 Um      | pm, nm, um, mm, cm or m
            20,5um     | is no length; write a decimal point for the comma, "20.5um"
            ''         | is no length
            um         | is no length
            NaN um     | is no length
            Infinity m | is no length
            1 2 um     | is no length
            65 um wide | is no length
            0x10 m     | is no length
            --1 m      | is no length
            3e9999 m   | is no length
            """)
    void whatIsNoLengthIsToldWithItsRemedy(String text, String words) {
        assertThatThrownBy(() -> Lengths.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContainingAll('"' + text + '"', words);
    }

    @Test
    void complaintsStayOneShortLineForLongAndStrangeText() {
        assertThatThrownBy(() -> Lengths.parse("9".repeat(1_000_000) + "\n\u001b[31m"))
                .isInstanceOf(IllegalArgumentException.class)
                .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(200).doesNotContain("\n", "\u001b"));
    }

    @ParameterizedTest
    @CsvSource({
        "65e-6, 65 um",
        "818.69e-9, 818.69 nm",
        "1e-3, 1 mm",
        "0.3, 300 mm",
        "12, 12 m",
        "999.9999e-9, 1 um",
        "48.7987987987e-9, 48.7988 nm",
        "-5e-9, -5 nm",
        "0, 0 m",
        "NaN, NaN m"
    })
    void writesALengthInTheUnitThatPeopleUse(double meters, String text) {
        assertThat(Lengths.format(meters)).isEqualTo(text);
    }

    @Test
    void readsItsOwnOutput() {
        Random random = new Random(1);
        for (int i = 0; i < 1000; i++) {
            double meters = Math.pow(10, -20 + 40 * random.nextDouble());
            double back = Lengths.parse(Lengths.format(meters));
            // Six digits are written: half a unit of the last is at most 5e-6 of the value.
            assertThat(Math.abs(back / meters - 1)).as(Double.toString(meters)).isLessThanOrEqualTo(5.0001e-6);
        }
    }

    /** A plane through a level scan leaves 1e-23 m. */
    @Test
    void roundingErrorsAreZero() {
        assertThat(Lengths.rounded(1.32e-23, 3)).isEqualTo("0 m");
        assertThat(Lengths.rounded(2e-15, 3)).isEqualTo("0.002 pm");
    }

    @Test
    void anglesWithoutUnitAreDegrees() {
        assertThat(Angles.parse("180")).isEqualTo(Math.PI);
        assertThat(Angles.parse("-90deg")).isEqualTo(-Math.PI / 2);
        assertThat(Angles.parse("90\u00b0")).isEqualTo(Math.PI / 2);
        assertThat(Angles.parse(" 1.5 rad ")).isEqualTo(1.5);
        assertThat(Angles.parse("4.5e1")).isEqualTo(Math.PI / 4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "deg", "x", "1d", "0x1p3", "NaN", "Infinity", "1e999", "1,5", "30 grad"})
    void anythingElseIsNoAngle(String text) {
        assertThatThrownBy(() -> Angles.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContainingAll('"' + text + '"', "as in 30deg");
    }

    @ParameterizedTest
    @CsvSource({"100, 2, 100", "99.96, 2, 100", "131.4, 2, 130", "0.0344, 2, 0.034", "0, 3, 0"})
    void roundedNumbersAreNoPowersOfTen(double value, int digits, String text) {
        assertThat(Decimals.rounded(value, digits)).isEqualTo(text);
    }

    /** "1234 to 1234 nm" hid an interval of 0.2 nm. */
    @ParameterizedTest
    @CsvSource({"1234.04, 0.1, 1234.04", "1071, 87, 1071", "9252.6, 2850, 9300", "2500, 0, 2500.00"})
    void aValueHasTheDigitsThatItsUncertaintyLeaves(double value, double uncertainty, String text) {
        assertThat(Decimals.within(value, uncertainty)).isEqualTo(text);
    }

    private static final List<String> NAMES = List.of("Height", "Weight", "Phase", "ZSensor", "X");

    @ParameterizedTest
    @CsvSource({"Hight, Height", "heigth, Height", "PHASES, Phase", "Z Sensor, ZSensor", "wieght, Weight"})
    void aSlipOfTheFingerIsNearItsName(String written, String meant) {
        assertThat(Text.nearest(written, NAMES)).contains(meant);
    }

    /** Two wrong letters of three or four would match any short words. */
    @ParameterizedTest
    @ValueSource(strings = {"", "Y", "red", "Topography"})
    void anotherWordIsNearNone(String written) {
        assertThat(Text.nearest(written, NAMES)).isEmpty();
    }

    @Test
    void quotedTextIsCutAndHasNoControlCharacters() {
        assertThat(Text.quoted("a\nb\r\u001b[1m\u2028c")).isEqualTo("\"a?b??[1m?c\"");
        assertThat(Text.quoted("x".repeat(60))).isEqualTo("\"" + "x".repeat(60) + "\"");
        assertThat(Text.quoted("x".repeat(61))).isEqualTo("\"" + "x".repeat(60) + "...\"");
    }

    @Test
    void oneDegreeIsSingular() {
        assertThat(List.of(Text.wholeDegrees(0.6), Text.wholeDegrees(-1.4), Text.wholeDegrees(-0.4)))
                .containsExactly("1 degree", "-1 degree", "0 degrees");
    }
}
