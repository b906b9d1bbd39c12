package sunbeam.app.files.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

class LightTableTest {
    @TempDir
    private Path folder;

    private CieTable table(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("lamp.csv"), text);
        return LightTable.of(Choices.none().with(LightSettings.ILLUMINANT, file.toString()));
    }

    /** Rows every 20 nm from a wavelength to 780 nm, each with the same ending. */
    private static String rows(int from, String ending) {
        return IntStream.rangeClosed(0, (780 - from) / 20)
                .mapToObj(i -> from + 20 * i + ending + "\n")
                .collect(Collectors.joining());
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '"',
            value = {"\"nm,power\n\", \",\"", "\"# lamp, a\tb\n\", ;", "\"\", \"\t\""},
            ignoreLeadingAndTrailingWhitespace = false)
    void equalPowerOfAnyUnitIsIlluminantE(String header, String separator) throws IOException {
        String rows = rows(300, (separator.strip().isEmpty() ? "\t" : separator.strip()) + "7");

        double[] white = table(header + rows).white();

        // Of the table's own sums: (1, 1, 1) to four digits.
        assertThat(white).containsExactly(new double[] {1, 1, 1}, within(3e-4));
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '"',
            value = {
                "\"\", no row",
                "\"0.38,1\n0.78,1\n\", nanometers",
                "\"400,1\n780,1\n\", reach from 400 to 780 nm",
                "\"380,1\n500,1\n780,1\n\", every 20 nm",
                "\"380,1\n390,-1\n\", not negative",
                "\"380,1\n390,NaN\n\", not negative",
                "\"380,1\n380,1\n\", twice",
                "\"380\n\", two columns",
                "\"380,1,2\n\", two columns",
                "\"380,1\nlamp,1\n\", is no wavelength",
            })
    void invalidSpectraAreRefusedInOneLine(String text, String problem) {
        assertThatThrownBy(() -> table(text == null ? "" : text))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll("lamp.csv", problem)
                .message()
                .doesNotContain("\n");
    }

    @Test
    void binaryFilesAreRefused() throws IOException {
        Path file = Files.write(folder.resolve("lamp.csv"), new byte[] {'3', '8', (byte) 0xff, (byte) 0xfe, 0});

        assertThatThrownBy(() -> LightTable.of(Choices.none().with(LightSettings.ILLUMINANT, file.toString())))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("not text in UTF-8");
    }

    /** A line a fifth of a nanometer wide, between whole nanometers. */
    @Test
    void aNarrowLineIsTheLightOfItsWavelength() throws IOException {
        String text = "546.4,0\n546.5,1000\n546.6,0\n" + rows(380, ",0");
        double[] line = LightTable.of(Choices.none()
                        .with(LightSettings.ILLUMINANT, "E")
                        .with(LightSettings.WAVELENGTHS, WavelengthBand.parse("546.5nm")))
                .white();

        // Both are split between 546 and 547 nm; rounding of the sums.
        assertThat(table(text).white()).containsExactly(line, within(1e-9));
    }

    @Test
    void darknessIsNoLight() {
        assertThatThrownBy(() -> table(rows(380, ",0")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("no power");
        Choices band = Choices.none()
                .with(LightSettings.ILLUMINANT, "LED-B3")
                .with(LightSettings.WAVELENGTHS, WavelengthBand.parse("380nm"));
        assertThatThrownBy(() -> LightTable.of(band))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("no power");
    }
}
