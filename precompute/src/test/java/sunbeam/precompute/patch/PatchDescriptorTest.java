package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.patch.PatchLoader.PatchDescriptor;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.setting.SettingException;

class PatchDescriptorTest {
    private static final String SCALE = "\"width\": \"65 um\", \"maxHeight\": \"375 nm\"";

    @TempDir
    Path folder;

    private Path inside;

    @BeforeEach
    void writeImages() throws IOException {
        inside = Files.createDirectory(folder.resolve("inside"));
        for (Path place : new Path[] {folder, inside, Files.createDirectory(inside.resolve("deep"))}) {
            TestImages.write(TestImages.gray8(4, 2, (c, r, b) -> c), place.resolve("scan.png"));
        }
    }

    private Path descriptor(String json) throws IOException {
        return Files.writeString(inside.resolve("scan.json"), json);
    }

    private void assertRefused(String json, String... complaints) throws IOException {
        Path file = descriptor(json);
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
        PatchDescriptor descriptor = PatchDescriptor.read(descriptor("""
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
        assertRefused("{" + keys.replace('@', '\n') + "}", complaints.split(" & "));
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
        assertThatThrownBy(() -> PatchDescriptor.read(descriptor(json)))
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
        assertRefused("{\"note\": " + "[".repeat(100_000), "brackets (at most 20 within each other)");
        Path file = Files.write(inside.resolve("scan.json"), new byte[] {'{', '"', (byte) 0xff, (byte) 0xfe, '"'});
        assertThatThrownBy(() -> PatchDescriptor.read(file)).isInstanceOf(InputException.class);
        assertRefused(" ".repeat(1 << 20) + "{}", "1 MiB");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../scan.png", "deep/../../scan.png", "deep/../scan.png", "..", "/etc/hostname", "", " "})
    void refusesPathsThatLeaveTheFolder(String heights) throws IOException {
        assertRefused("{\"heights\": \"" + heights + "\", " + SCALE + "}", "own folder");
    }

    @Test
    void refusesALinkThatLeavesTheFolder() throws IOException {
        Files.createSymbolicLink(inside.resolve("link.png"), folder.resolve("scan.png"));
        Files.createSymbolicLink(inside.resolve("up"), folder);

        assertRefused("{\"heights\": \"link.png\", " + SCALE + "}", "leads out of the descriptor's folder");
        assertRefused("{\"heights\": \"up/scan.png\", " + SCALE + "}", "leads out of the descriptor's folder");
    }
}
