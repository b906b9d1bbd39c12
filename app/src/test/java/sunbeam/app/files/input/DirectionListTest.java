package sunbeam.app.files.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Tables of directions and of a lamp's power. */
final class DirectionListTest {
    private static final String HEADER = "theta_i,phi_i,theta_r,phi_r";

    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("in.csv"), text);
    }

    private DirectionList read(String text) throws IOException {
        return DirectionList.read(file(text));
    }

    private void assertRefused(String text, String... words) {
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(folder.resolve("in.csv").toString())
                .hasMessageContainingAll(words);
    }

    @Test
    void columnsAreFoundByNameAndOthersIgnored() throws IOException {
        DirectionList list =
                read("name,phi_i, theta_i ,note,theta_r,phi_r\na,1,2,\"x, \"\"y\"\"\",3,4\nb,-3.5e1,.5,,0,0\n");
        assertThat(list.columns()).containsExactly("theta_i", "phi_i", "theta_r", "phi_r");
        assertThat(list.rows()).containsExactly(new double[] {2, 1, 3, 4}, new double[] {0.5, -35, 0, 0});
    }

    @ParameterizedTest
    @ValueSource(strings = {"sep=,\n", "\uFEFFSEP=,\r\n", "\"sep=,\"\n", "sep=;\n", "sep=\t\r\n", "sep=|\n"})
    void excelsSeparatorIsRead(String line) throws IOException {
        String separator = line.replaceAll("(?s).*=(.).*", "$1");
        String rows = (HEADER + "\n30,0,10,180\n").replace(",", separator);

        assertThat(read(line + rows).rows()).containsExactly(new double[] {30, 0, 10, 180});
        String light = "380,0\n400,1\n"
                + IntStream.rangeClosed(21, 39).mapToObj(i -> 20 * i + ",1\n").collect(Collectors.joining());
        assertThat(table(line + light.replace(",", separator)).white())
                .isEqualTo(table(light).white());
    }

    @Test
    void filesFromOtherSystemsAreRead() throws IOException {
        DirectionList list = read("\uFEFF" + HEADER + ",wavelength\r\n\r\n1,2,0,0,550\r\n3,4,0,0,600");
        assertThat(list.rows()).containsExactly(new double[] {1, 2, 0, 0, 550}, new double[] {3, 4, 0, 0, 600});
    }

    @Test
    void aHyphenIsStandardInput() throws IOException {
        InputStream terminal = System.in;
        System.setIn(new ByteArrayInputStream((HEADER + "\n1,2,3,4\n").getBytes(StandardCharsets.UTF_8)));
        try {
            assertThat(DirectionList.read(Path.of("-")).rows()).containsExactly(new double[] {1, 2, 3, 4});
        } finally {
            System.setIn(terminal);
        }
    }

    @Test
    void aQuotedFieldMayCrossLinesWhichAreCounted() throws IOException {
        String quoted = "note," + HEADER + "\n\"two\nlines\",1,2,0,0\n,3,4,";
        assertThat(read(quoted + "0,0\n").rows()).hasSize(2);
        assertRefused(quoted + "90,0\n", "line 4, column theta_r: 90.0 must lie in 0..89.999 degrees");
    }

    @Test
    void mistakesAreNamedWithLineAndColumn() {
        assertRefused(HEADER + "\n1,,0,0\n", "line 2, column phi_i: ''");
        assertRefused(HEADER + "\nnan,1,0,0\n", "line 2, column theta_i: 'nan'");
        assertRefused(HEADER + "\n1e999,1,0,0\n", "finite");
        assertRefused(HEADER + ",phi_i\n1,2,0,0,3\n", "two columns phi_i");
        assertRefused(HEADER + "\n\"1,2\n", "Unclosed quoted field", "line 2");
        assertRefused("", "empty");
        assertRefused(HEADER + "\n\n", "no row");
    }

    @Test
    void aLineWithoutEndTakesNoMemory() {
        assertRefused(HEADER + "\n" + "1".repeat(70_000), "line 2", "65536", "is this a table?");
        assertRefused(HEADER + "\n" + "1,".repeat(70_000), "line 2", "65536");
        assertRefused(HEADER + "\n1,\"" + "2\n".repeat(70_000), "line 2");
    }

    @Test
    void aFolderIsNoList() {
        assertThatThrownBy(() -> DirectionList.read(folder))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("is a folder");
    }

    private CieTable table(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("lamp.csv"), text);
        return LightTable.of(Choices.none().with(MethodSettings.ILLUMINANT, file.toString()));
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

        assertThatThrownBy(() -> LightTable.of(Choices.none().with(MethodSettings.ILLUMINANT, file.toString())))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("not text in UTF-8");
    }

    /** A line a fifth of a nanometer wide, between whole nanometers. */
    @Test
    void aNarrowLineIsTheLightOfItsWavelength() throws IOException {
        String text = "546.4,0\n546.5,1000\n546.6,0\n" + rows(380, ",0");
        double[] line = LightTable.of(Choices.none()
                        .with(MethodSettings.ILLUMINANT, "E")
                        .with(MethodSettings.WAVELENGTHS, WavelengthBand.parse("546.5nm")))
                .white();

        // Both are split between 546 and 547 nm; rounding of the sums.
        assertThat(table(text).white()).containsExactly(line, within(1e-9));
    }

    @Test
    void aLedInStepsOfFiveNanometersIsSmoothAndALaserIsNot() throws IOException {
        String led = rows(
                5,
                at -> Math.exp(-0.5 * Math.pow((at - 452) / 10, 2))
                        + 0.5 * Math.exp(-0.5 * Math.pow((at - 575) / 58, 2)));
        String laser = rows(5, at -> at == 530 ? 1 : 0);

        assertThat(table(led).isSmooth()).isTrue();
        assertThat(table(laser).isSmooth()).isFalse();
    }

    private static String rows(int step, DoubleUnaryOperator power) {
        return IntStream.rangeClosed(0, 400 / step)
                .map(i -> 380 + i * step)
                .mapToObj(at -> at + "," + power.applyAsDouble(at) + "\n")
                .collect(Collectors.joining());
    }

    @Test
    void darknessIsNoLight() {
        assertThatThrownBy(() -> table(rows(380, ",0")))
                .isInstanceOf(InputException.class)
                .hasMessageContainingAll("no power");
        Choices band = Choices.none()
                .with(MethodSettings.ILLUMINANT, "LED-B3")
                .with(MethodSettings.WAVELENGTHS, WavelengthBand.parse("380nm"));
        assertThatThrownBy(() -> LightTable.of(band))
                .isInstanceOf(SettingException.class)
                .hasMessageContainingAll("no power");
    }
}
