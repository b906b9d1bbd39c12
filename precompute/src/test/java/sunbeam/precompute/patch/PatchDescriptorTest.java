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

class PatchDescriptorTest {
    private static final String SCALE = "\"width\": \"65 um\", \"maxHeight\": \"375 nm\"";

    @TempDir
    Path folder;

    private Path inside;

    @BeforeEach
    void writeImages() throws IOException {
        inside = Files.createDirectory(folder.resolve("inside"));
        for (Path place : new Path[] {folder, inside, Files.createDirectory(inside.resolve("deep"))}) {
            TestImages.write(TestImages.grey8(4, 2, (c, r, b) -> c), place.resolve("scan.png"));
        }
    }

    private Path descriptor(String json) throws IOException {
        return Files.writeString(inside.resolve("scan.json"), json);
    }

    private void assertRefused(String json, String... complaints) throws IOException {
        Path file = descriptor(json);
        assertThatThrownBy(() -> PatchDescriptorReader.read(file))
                .isInstanceOf(PatchException.class)
                .hasMessageContaining(file.toString())
                .satisfies(e -> assertThat(e.getMessage())
                        .contains(complaints)
                        .doesNotContain("\n")
                        .hasSizeLessThan(400));
    }

    @Test
    void readsEveryKey() throws IOException {
        PatchDescriptor descriptor = PatchDescriptorReader.read(descriptor("""
                {
                  "heights": "scan.png", "width": "65 um", "height": "32.5um", "maxHeight": "375 nm",
                  "channel": "green", "levelling": "plane", "note": "shed skin"
                }
                """));

        assertThat(descriptor.heights()).isEqualTo(inside.resolve("scan.png"));
        assertThat(descriptor.scale().width().metres()).isEqualTo(65e-6);
        assertThat(descriptor.scale().extent().orElseThrow().metres()).isEqualTo(32.5e-6);
        assertThat(descriptor.scale().maxHeight().metres()).isEqualTo(375e-9);
        assertThat(descriptor.channel()).contains(Channel.GREEN);
        assertThat(descriptor.levelling()).contains(Levelling.PLANE);
        assertThat(descriptor.note()).isEqualTo("shed skin");
    }

    @Test
    void needsOnlyHeightsWidthAndMaxHeight() throws IOException {
        PatchDescriptor descriptor =
                PatchDescriptorReader.read(descriptor("{\"heights\": \"scan.png\", " + SCALE + "}"));

        assertThat(descriptor.scale().extent()).isEmpty();
        assertThat(descriptor.channel()).isEmpty();
        assertThat(descriptor.levelling()).isEmpty();
        assertThat(descriptor.note()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "'\"width\": \"65 um\", \"maxHeight\": \"375 nm\"', heights",
        "'\"heights\": \"scan.png\", \"maxHeight\": \"375 nm\"', width",
        "'\"heights\": \"scan.png\", \"width\": \"65 um\"', maxHeight"
    })
    void namesAMissingKeyAndWhatToAdd(String keys, String missing) throws IOException {
        assertRefused("{" + keys + "}", "lacks the key \"" + missing + "\"", "add for example");
    }

    @Test
    void namesAnUnknownKeyItsLineAndTheKnownOnes() throws IOException {
        assertRefused(
                "{\n \"heights\": \"scan.png\",\n \"widht\": \"65 um\"\n}",
                "line 3",
                "\"widht\"",
                "unknown key",
                "maxHeight");
    }

    @ParameterizedTest
    @ValueSource(strings = {"65", "true", "null", "[\"65 um\"]", "{}"})
    void refusesValuesThatAreNoText(String value) throws IOException {
        assertRefused("{\n\"width\": " + value + ",\n\"heights\": \"scan.png\"}", "line 2", "\"width\" is no text");
    }

    @Test
    void asksForTheUnitOfANumber() throws IOException {
        assertRefused("{\"width\": 65}", "with their unit");
        assertRefused("{\"heights\": \"scan.png\",\n\"width\": \"65\", \"maxHeight\": \"1um\"}", "line 2", "no unit");
    }

    @ParameterizedTest
    @CsvSource({"channel, red and blue", "levelling, flat"})
    void namesAnUnknownWord(String key, String word) throws IOException {
        assertRefused(
                "{\"heights\": \"scan.png\", " + SCALE + ",\n\"" + key + "\": \"" + word + "\"}", "line 2", key, word);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "heights: scan.png",
                "[]",
                "\"scan.png\"",
                "{",
                "{\"heights\"",
                "{\"heights\": \"scan.png\",}",
                "{\"heights\": \"scan.png\", \"heights\": \"other.png\"}",
                "{} {}",
                "{} x",
                "// comment\n{}"
            })
    void refusesWhatIsNoSingleJsonObject(String json) throws IOException {
        assertRefused(json, "scan.json");
    }

    @Test
    void namesTheLineOfBrokenJson() throws IOException {
        assertRefused("{\n\"heights\": \"scan.png\"\n\"width\": \"65 um\"}", "line 3", "no valid JSON");
    }

    @Test
    void refusesDeepNestingAndInvalidUtf8() throws IOException {
        assertRefused("{\"note\": " + "[".repeat(100_000), "\"note\" is no text");
        Path file = Files.write(inside.resolve("scan.json"), new byte[] {'{', '"', (byte) 0xff, (byte) 0xfe, '"'});
        assertThatThrownBy(() -> PatchDescriptorReader.read(file)).isInstanceOf(PatchException.class);
    }

    @Test
    void refusesAFileThatIsTooLarge() throws IOException {
        assertRefused(" ".repeat(DescriptorKeys.MOST_BYTES) + "{}", "1 MiB");
    }

    @Test
    void findsTheImageBelowTheDescriptorsFolder() throws IOException {
        PatchDescriptor descriptor =
                PatchDescriptorReader.read(descriptor("{\"heights\": \"deep/scan.png\", " + SCALE + "}"));

        assertThat(descriptor.heights()).exists();
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

    @Test
    void followsALinkThatStaysInTheFolder() throws IOException {
        Files.createSymbolicLink(inside.resolve("link.png"), inside.resolve("deep/scan.png"));

        assertThat(PatchDescriptorReader.read(descriptor("{\"heights\": \"link.png\", " + SCALE + "}"))
                        .heights())
                .exists();
    }

    @Test
    void namesAnImageThatIsNotThere() throws IOException {
        assertRefused("{\"heights\": \"scam.png\", " + SCALE + "}", "scam.png", "no file");
        assertRefused("{\"heights\": \"a\\u0000b\", " + SCALE + "}", "\"a?b\"", "no file name");
    }
}
