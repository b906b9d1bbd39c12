package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/** How a file's own scale and what the user says of it come together. */
class ScanHeightsTest {
    private static final String NUMBERS = "0 10 20 30\n40 50 60 70\n80 90 100 110\n";
    private static final String HEADER = "# Channel: Height\n# Width: 4.0 um\n# Height: 3.0 um\n# Value units: nm\n";

    @TempDir
    Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("scan.txt"), text);
    }

    /** Settings and words in turn. */
    private static Patch load(Path file, Object... choices) {
        PatchRequest request = PatchRequests.parse(file.toString(), null, null, null, null, "none");
        for (int i = 0; i < choices.length; i += 2) {
            request = PatchRequests.with(request, (Setting<?>) choices[i], (String) choices[i + 1]);
        }
        return new PatchLoader(List.of(), BuiltInPatches::generate).load(request);
    }

    @Test
    void aFileThatKnowsItsScaleNeedsNothingSaid() throws IOException {
        HeightMap map = load(file(HEADER + NUMBERS)).heights();

        assertThat(map.width()).isCloseTo(4e-6, within(1e-20));
        assertThat(map.height()).isCloseTo(3e-6, within(1e-20));
        assertThat(map.at(1, 2)).isCloseTo(90e-9, within(1e-22));
    }

    @Test
    void aMisspeltChannelIsAskedBackBesideTheList() throws IOException {
        Path file = file(HEADER + NUMBERS);

        assertThatThrownBy(() -> load(file, PatchSettings.CHANNEL, "Hight"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("scan.txt, which has Height (did you mean \"Height\"?)");
        assertThatThrownBy(() -> load(file, PatchSettings.CHANNEL, "Phase"))
                .hasMessageEndingWith("scan.txt, which has Height");
    }

    @ParameterizedTest
    @CsvSource({"width, 5um, 4 um wide", "height, 5um, 3 um high", "heightUnit, um, in nm", "maxHeight, 1nm, in nm"})
    void whatAFileKnowsIsNotOverruled(String key, String word, String complaint) throws IOException {
        Path file = file(HEADER + NUMBERS);
        var setting = PatchSettings.OF_FILES.stream()
                .filter(s -> s.key().equals(key))
                .findFirst()
                .orElseThrow();

        assertThatThrownBy(() -> load(file, setting, word))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("contradicts")
                .hasMessageContaining(complaint);
    }

    @ParameterizedTest
    @CsvSource({"width, 4um", "height, 0.003 mm", "heightUnit, nm"})
    void whatAFileKnowsMayBeSaidAgain(String key, String word) throws IOException {
        Path file = file(HEADER + NUMBERS);
        var setting = PatchSettings.OF_FILES.stream()
                .filter(s -> s.key().equals(key))
                .findFirst()
                .orElseThrow();

        HeightMap map = load(file, setting, word).heights();

        assertThat(map.width()).isEqualTo(load(file).heights().width());
        assertThat(map.at(1, 2)).isEqualTo(load(file).heights().at(1, 2));
    }

    @Test
    void asksForWhatAFileDoesNotSay() throws IOException {
        Path file = file(NUMBERS);

        assertThatThrownBy(() -> load(file))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("--width 20um and --height-unit nm");
        assertThatThrownBy(() -> load(file, PatchSettings.WIDTH, "4um"))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("in which unit its heights are; add for example --height-unit nm");
        assertThatThrownBy(() -> load(file, PatchSettings.HEIGHT_UNIT, "nm"))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("how large the scan is; add for example --width 20um");
    }

    @Test
    void whatIsSaidCompletesAFile() throws IOException {
        HeightMap map = load(file(NUMBERS), PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, "nm")
                .heights();

        assertThat(map.pitchY()).isCloseTo(1e-6, within(1e-20));
        assertThat(map.relief()).isCloseTo(110e-9, within(1e-22));
    }

    @Test
    void numbersInOneRowNeedTheirColumns() throws IOException {
        Path file = file(NUMBERS.replace('\n', ' '));

        assertThatThrownBy(() -> load(file, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, "nm"))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("--columns is missing")
                .hasMessageContaining("12 numbers in one row");
        HeightMap map = load(
                        file, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, "nm", PatchSettings.COLUMNS, "4")
                .heights();
        assertThat(map.rows()).isEqualTo(3);
        assertThat(map.at(1, 2)).isCloseTo(90e-9, within(1e-22));
        assertThatThrownBy(() -> load(file, PatchSettings.COLUMNS, "5"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("--columns 5 does not divide the 12 numbers");
    }

    @ParameterizedTest
    @CsvSource({"m, relief of 110 m", "pm, ''"})
    void aUnitThatCannotBeIsRefused(String unit, String complaint) throws IOException {
        Path file = file(NUMBERS);
        if (complaint.isEmpty()) {
            // 110 pm are little, but more than a hundredth of an atom.
            assertThat(load(file, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, unit)
                            .heights()
                            .relief())
                    .isCloseTo(110e-12, within(1e-24));
            return;
        }
        assertThatThrownBy(() -> load(file, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, unit))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("--height-unit " + unit)
                .hasMessageContaining(complaint);
    }

    @Test
    void aUnitThatIsTooSmallIsRefusedWithTheRemedy() throws IOException {
        Path metres = file("0 1e-7\n1e-7 0\n");

        assertThatThrownBy(() -> load(metres, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, "nm"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("less than a hundredth of an atom; give a larger unit");
    }

    @Test
    void aReliefBelowAPicometreIsRefusedWithItsCause() throws IOException {
        Path file = file((HEADER + NUMBERS).replace("units: nm", "units: fm").replace("110", "1"));

        assertThatThrownBy(() -> load(file))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining("relief of 0.1 pm, less than a hundredth of an atom")
                .hasMessageContaining("its scale is wrong");
    }

    @Test
    void aFloatImageInMetresIsNoMirror() throws IOException {
        Path file =
                TestImages.write(TestImages.grey32f(4, 4, (c, r, b) -> 534e-9 * c / 3), folder.resolve("metres.tiff"));

        assertThatThrownBy(() -> load(file, PatchSettings.WIDTH, "4um", PatchSettings.MAX_HEIGHT, "534nm"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("--max-height 534 nm makes a relief of 0.285156 pm")
                .hasMessageContaining("reach over 534 nm if they are metres: give --height-unit m");
        HeightMap map = load(file, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, "m")
                .heights();
        // Seven digits of a float.
        assertThat(map.relief()).isCloseTo(534e-9, within(5e-14));
    }

    @Test
    void wholeNumbersHaveNoUnit() throws IOException {
        Path file = TestImages.write(TestImages.grey8(4, 4, (c, r, b) -> c), folder.resolve("grey.png"));

        assertThatThrownBy(() -> load(file, PatchSettings.WIDTH, "4um", PatchSettings.HEIGHT_UNIT, "nm"))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("--height-unit nm is for images of floats")
                .hasMessageContaining("--max-height");
    }

    @Test
    void aDescriptorOfAScanNeedsNoScale() throws IOException {
        file(HEADER + NUMBERS);
        Path json = Files.writeString(folder.resolve("skin.json"), "{\"heights\": \"scan.txt\"}");

        assertThat(load(json).source()).contains("scan.txt (text, channel Height), 4 x 3 samples, 4 um x 3 um");
    }
}
