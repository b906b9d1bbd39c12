package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.patch.PatchLoader.PatchDescriptor;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.setting.ChoiceOrigin;
import sunbeam.precompute.setting.SettingException;

/** Patches by their names, with the scale of options or of a descriptor. */
class PatchLoaderTest {
    @TempDir
    Path folder;

    private String ramp() throws IOException {
        return TestImages.write(TestImages.gray8(256, 2, (c, r, b) -> c), folder.resolve("ramp.png"))
                .toString();
    }

    private String descriptor(String extra) throws IOException {
        ramp();
        String json = "{\"heights\": \"ramp.png\", \"width\": \"12.8 um\", \"maxHeight\": \"255 nm\"" + extra + "}";
        return Files.writeString(folder.resolve("skin.json"), json).toString();
    }

    private void assertRefused(PatchRequest request, String... complaints) {
        assertThatThrownBy(() -> PatchRequests.load(request))
                .isInstanceOf(InputException.class)
                .satisfies(e -> assertThat(e.getMessage()).contains(complaints).doesNotContain("\n"));
    }

    private void assertChoiceRefused(PatchRequest request, String... complaints) {
        assertThatThrownBy(() -> PatchRequests.load(request))
                .isInstanceOf(SettingException.class)
                .satisfies(e -> assertThat(((SettingException) e).place()).isEqualTo(ChoiceOrigin.Place.OPTION))
                .satisfies(e -> assertThat(e.getMessage()).contains(complaints).doesNotContain("\n"));
    }

    @Test
    void findsABuiltInPatchAndLevelsIt() {
        Patch patch = PatchRequests.load("blaze");

        assertThat(patch.name()).isEqualTo("blaze");
        assertThat(patch.source()).contains("built-in blaze", "128 x 32 samples", "levelling mean");
        assertThat(patch.warnings()).isEmpty();
        // Rounding of the mean.
        assertThat(patch.heights().maximum() + patch.heights().minimum()).isBetween(-1e-20, 1e-20);
    }

    @Test
    void readsAnImageWithItsScale() throws IOException {
        Patch patch = PatchRequests.load(PatchRequests.of(ramp(), WIDTH, "12.8um", MAX_HEIGHT, "255nm", LEVEL, "none")
                .raw(true));

        assertThat(patch.name()).isEqualTo("ramp");
        assertThat(patch.heights().columns()).isEqualTo(256);
        assertThat(patch.heights().pitchX()).isEqualTo(12.8e-6 / 256);
        for (int column = 0; column < 256; column++) {
            // Three roundings of relative 1e-16 on at most 255 nm.
            assertThat(patch.heights().at(column, 1) - column * 1e-9).isBetween(-1e-22, 1e-22);
        }
        assertThat(patch.source()).contains("ramp.png (image, channel grey)", "256 x 2 samples, 12.8 um x 100 nm");
        assertThat(patch.warnings()).isEmpty();
    }

    @Test
    void theScaleOfADescriptorAndOfTheOptionsGiveTheSamePatch() throws IOException {
        Patch described = PatchRequests.load(descriptor(""));
        assertThat(described.name()).isEqualTo("skin");
        // Scans without a descriptor are leveled by their plane and blended unless read raw.
        Patch asked = PatchRequests.load(
                PatchRequests.of(ramp(), WIDTH, "12.8um", MAX_HEIGHT, "255nm").raw(true));

        assertThat(described.heights().digest()).isEqualTo(asked.heights().digest());
    }

    @ParameterizedTest
    @CsvSource({"65um, , , --width, 65 um", ", 65um, , --height, 65 um", ", , 375nm, --max-height, 375 nm"})
    void refusesAScaleForAPatchThatHasOne(String width, String extent, String maxHeight, String option, String given)
            throws IOException {
        assertChoiceRefused(
                PatchRequests.of(descriptor(""), WIDTH, width, HEIGHT, extent, MAX_HEIGHT, maxHeight),
                option + " " + given + " contradicts",
                "skin.json",
                "leave it out");
        assertChoiceRefused(
                PatchRequests.of("blaze", WIDTH, width, HEIGHT, extent, MAX_HEIGHT, maxHeight),
                option + " " + given + " contradicts the built-in patch blaze");
    }

    @Test
    void refusesOptionsThatContradictTheDescriptor() throws IOException {
        String file = descriptor(", \"levelling\": \"plane\", \"channel\": \"grey\"");

        assertChoiceRefused(PatchRequests.of(file, LEVEL, "mean"), "--level mean contradicts", "says plane");
        assertChoiceRefused(PatchRequests.of(file, CHANNEL, "red"), "--channel red contradicts", "says grey");
        Patch same = PatchRequests.load(file, CHANNEL, "gray", LEVEL, "plane");
        assertThat(same.source()).contains("levelling plane");
        // A ramp is a plane; rounding of 255 nm remains.
        assertThat(same.heights().relief()).isLessThan(1e-21);
    }

    @Test
    void listsThePatchesWhenOneIsUnknown() {
        String unknown = "--patch blase is neither a built-in patch nor an existing file";
        assertRefused(PatchRequests.of("blase"), unknown, "blaze", "descriptor", "image");
        assertRefused(PatchRequests.of(" "), "--patch", "is empty");
        assertRefused(PatchRequests.of(folder.resolve("x.json")), "nor an existing file");
        assertRefused(PatchRequests.of("a\0b"), "no file name");
        assertRefused(PatchRequests.of(folder), folder.toString(), "is a folder");
    }

    @Test
    void fillsMissingSamplesAndSaysHowMany() throws IOException {
        TestImages.Samples tilted = (c, r, b) -> c >= 12 && r >= 12 ? Double.NaN : 100 + 5 * c - 3 * r;
        Path file = TestImages.write(TestImages.gray32f(16, 16, tilted), folder.resolve("holes.tiff"));

        Patch patch = PatchRequests.load(file, WIDTH, "1um", MAX_HEIGHT, "1nm", LEVEL, "plane");

        assertThat(patch.warnings().get(0)).contains("16 of 256 samples are missing");
        assertThat(patch.warnings().get(1)).contains("is a mirror");
        // The plane through the present samples fills the hole, too: rounding of heights of 200 nm remains.
        assertThat(patch.heights().relief()).isLessThan(1e-21);
    }

    @ParameterizedTest
    @CsvSource({"elaphe, 8.2 %", "xenopeltis, 21.6 %"})
    void snakeSkinsAreSteeperThanScalarTheoryLikesAndDoNotTile(String name, String share) {
        // Relative to the module's folder, in which tests run.
        Path file = Path.of("..", "..", "shared", "patches", name + ".json");
        assumeTrue(Files.exists(file), () -> "the measured patches are not there: " + file);
        List<String> warnings = PatchRequests.load(file).warnings();
        assertThat(warnings).hasSize(2);
        assertThat(warnings.get(0))
                .startsWith("the scan's repetition has a step that draws a cross: opposite borders differ by");
        assertThat(warnings.get(1)).startsWith("slopes too steep for scalar theory: " + share);
    }

    private static final String SCALE = "\"width\": \"65 um\", \"maxHeight\": \"375 nm\"";

    private Path inside;

    @BeforeEach
    void writeImages() throws IOException {
        inside = Files.createDirectory(folder.resolve("inside"));
        for (Path place : new Path[] {folder, inside, Files.createDirectory(inside.resolve("deep"))}) {
            TestImages.write(TestImages.gray8(4, 2, (c, r, b) -> c), place.resolve("scan.png"));
        }
    }

    private Path insideFile(String json) throws IOException {
        return Files.writeString(inside.resolve("scan.json"), json);
    }

    private void assertDescriptorRefused(String json, String... complaints) throws IOException {
        Path file = insideFile(json);
        assertThatThrownBy(() -> PatchRequests.load(file))
                .isInstanceOfAny(InputException.class, SettingException.class)
                .hasMessageContaining(file.toString())
                .satisfies(e -> assertThat(e.getMessage())
                        .contains(complaints)
                        .doesNotContain("\n")
                        .hasSizeLessThan(400));
    }

    @Test
    void readsEveryKey() throws IOException {
        PatchDescriptor descriptor = PatchDescriptor.read(insideFile("""
                {
                  "heights": "scan.png", "width": "65 um", "height": "32.5um", "maxHeight": "375 nm",
                  "channel": "green", "levelling": "plane", "note": "shed skin"
                }
                """));

        assertThat(descriptor.heights()).isEqualTo(inside.resolve("scan.png"));
        assertThat(descriptor.choices().find(PatchSettings.WIDTH)).contains(65e-6);
        assertThat(descriptor.choices().find(PatchSettings.HEIGHT)).contains(32.5e-6);
        assertThat(descriptor.choices().find(PatchSettings.MAX_HEIGHT)).contains(375e-9);
        assertThat(descriptor.choices().find(PatchSettings.CHANNEL)).contains("green");
        assertThat(descriptor.choices().find(PatchSettings.LEVEL)).contains(Leveling.PLANE);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            "width": "65 um", "maxHeight": "1um"                          | the key "heights" is missing & add for example
            "heights": "scan.png", "maxHeight": "1um"                     | "width": is missing & width 65um
            "heights": "scan.png", "width": "65 um"                       | "maxHeight": is missing & maxHeight 375nm
            "heights": "scan.png", "width": "65 um",@ "widht": "65 um"    | line 2 & "widht" & unknown key & maxHeight
            "heights": "scam.png", "width": "65 um", "maxHeight": "1um"   | scam.png & no file
            "heights": "a\\u0000b", "width": "65 um", "maxHeight": "1um" | "a?b" & no file name
            """)
    void namesWhatIsMissingOrUnknown(String keys, String complaints) throws IOException {
        assertDescriptorRefused("{" + keys.replace('@', '\n') + "}", complaints.split(" & "));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "", "heights: scan.png", "[]",
                "\"scan.png\"", "{", "{\"heights\"",
                "{} {}", "{} x", "// comment\n{}",
                "{\"width\": 1e}", "{\"width\": tru}", "{\"width\": \"\\q\"}",
                "{width: 1}", "{\"heights\": \"scan.png\",}", "{\"heights\": \"a.png\", \"heights\": \"b.png\"}"
            })
    void refusesTextsThatAreNoSingleJsonObject(String json) throws IOException {
        assertThatThrownBy(() -> PatchDescriptor.read(insideFile(json)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("scan.json")
                .message()
                .as("words of the parser")
                .doesNotContainIgnoringCase("token")
                .doesNotContainIgnoringCase("unexpected")
                .doesNotContainIgnoringCase("character");
    }

    @Test
    void refusesDeepNestingInvalidUtf8AndLargeFiles() throws IOException {
        assertDescriptorRefused("{\"note\": " + "[".repeat(100_000), "brackets (at most 20 within each other)");
        Path file = Files.write(inside.resolve("scan.json"), new byte[] {'{', '"', (byte) 0xff, (byte) 0xfe, '"'});
        assertThatThrownBy(() -> PatchDescriptor.read(file)).isInstanceOf(InputException.class);
        assertDescriptorRefused(" ".repeat(1 << 20) + "{}", "1 MiB");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../scan.png", "deep/../../scan.png", "deep/../scan.png", "..", "/etc/hostname", "", " "})
    void refusesPathsThatLeaveTheFolder(String heights) throws IOException {
        assertDescriptorRefused("{\"heights\": \"" + heights + "\", " + SCALE + "}", "own folder");
    }

    @Test
    void refusesALinkThatLeavesTheFolder() throws IOException {
        Files.createSymbolicLink(inside.resolve("link.png"), folder.resolve("scan.png"));
        Files.createSymbolicLink(inside.resolve("up"), folder);

        assertDescriptorRefused("{\"heights\": \"link.png\", " + SCALE + "}", "leads out of the descriptor's folder");
        assertDescriptorRefused(
                "{\"heights\": \"up/scan.png\", " + SCALE + "}", "leads out of the descriptor's folder");
    }
}
