package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.BoundUser;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.Images;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.PngFile;

/** Unusable surfaces are reported in one line with file or option, value and remedy. */
class BadPatchTest extends InWorkplace {
    @BeforeEach
    void layOut() throws IOException {
        Images.gray(workplace.resolve("scan.png"), 16, 16, (column, row) -> 13 * column + row);
    }

    @Test
    void aFileThatIsNotThere() throws Exception {
        assertRefused(
                "--patch nowhere.png --width 65um --max-height 375nm",
                "--patch nowhere.png is neither a built-in patch nor an existing file; give a");
    }

    @Test
    void aNameThatIsNeitherFileNorBuiltIn() throws Exception {
        assertRefused(
                "--patch blase",
                "--patch blase is neither a built-in patch nor an existing file; give a built-in patch (blaze, sinusoid,");
    }

    @Test
    void aFolder() throws Exception {
        assertRefused("--patch . --width 65um --max-height 375nm", "cannot read .: it is a folder; name a file in it");
    }

    @Test
    void aFileThatMayNotBeRead() throws Exception {
        Path scan = workplace.resolve("scan.png");
        Files.setPosixFilePermissions(scan, PosixFilePermissions.fromString("---------"));
        String commandLine = "brdf-map --size 8 --patch scan.png --width 65um --max-height 375nm";

        Complaint.assertThatIt(
                BoundUser.start(workplace.command(commandLine.split(" ", -1)), root)
                        .run(),
                Complaint.UNUSABLE_INPUT,
                "scan.png cannot be read; check its permissions");
        assertThat(workplace.files()).containsExactly("scan.png");
    }

    @Test
    void aFileThatIsNoImage() throws Exception {
        Files.writeString(workplace.resolve("notes.png"), "heights: see the other file\n");

        assertRefused(
                "--patch notes.png --width 65um --max-height 375nm",
                "notes.png is ",
                "format that Sunbeam knows",
                "Gwyddion");
    }

    @Test
    void anImageThatBreaksOff() throws Exception {
        byte[] whole = Files.readAllBytes(workplace.resolve("scan.png"));
        Files.write(workplace.resolve("half.png"), Arrays.copyOf(whole, whole.length / 2));

        assertRefused(
                "--patch half.png --width 65um --max-height 375nm", "half.png is damaged", "export the scan again");
    }

    @ParameterizedTest
    @CsvSource({
        "'', add for example --width 65um and --max-height 375nm",
        "--width 65um, add for example --max-height 375nm",
        "--max-height 375nm, add for example --width 65um"
    })
    void anImageWithoutScale(String options, String words) throws Exception {
        assertRefused("--patch scan.png " + options, "scan.png", words);
    }

    @ParameterizedTest
    @CsvSource({
        "--width 0um --max-height 375nm, '--width 0 m is out of range; give 1 nm to 100 mm'",
        "--width -65um --max-height 375nm, '--width -65 um is out of range; give'",
        "--width 65m --max-height 375nm, '--width 65 m is out of range; give'",
        "--width 65 --max-height 375nm, '--width \"65\" has no unit; write'",
        "--width wide --max-height 375nm, '--width \"wide\" is no length; write'",
        "--width NaNum --max-height 375nm, '--width \"NaNum\" is no length; write'",
        "--width 65um --height 0um --max-height 375nm, '--height 0 m is out of range; give'",
        "--width 65um --max-height 0nm, '--max-height 0 m is out of range; give 1 pm to 1 m'",
        "--width 65um --max-height -1nm, '--max-height -1 nm is out of range; give'",
        "--width 65um --max-height 375m, '--max-height 375 m is out of range; give'",
        "--width 65um --max-height 375mm, '--max-height 375 mm is absurd for the full scale of whole numbers'"
    })
    void aScaleThatCannotBe(String options, String words) throws Exception {
        assertRefused(Complaint.USAGE, "--patch scan.png " + options, words);
    }

    @Test
    void heightsThatAreAllMissing() throws Exception {
        Images.floats(workplace.resolve("nothing.tif"), 8, Float.NaN);

        assertRefused(
                "--patch nothing.tif --width 65um --max-height 375nm",
                "nothing.tif: all 64 samples are missing",
                "export the scan again");
    }

    @Test
    void aSinglePixel() throws Exception {
        Images.gray(workplace.resolve("one.png"), 1, 1, (column, row) -> 7);

        assertRefused("--patch one.png --width 65um --max-height 375nm", "one.png has 1 x 1 samples", "give at least");
    }

    @Test
    void aHeaderThatPromisesGigabytes() throws Exception {
        PngFile.writeWithHeaderOf(workplace.resolve("huge.png"), 40_000, 40_000);

        assertRefused("--patch huge.png --width 65um --max-height 375nm", "huge.png has 40000 x 40000 samples", "crop");
    }

    @Test
    void aDescriptorOfAMissingImage() throws Exception {
        Files.writeString(
                workplace.resolve("lost.json"),
                "{\"heights\": \"lost.png\", \"width\": \"65 um\", \"maxHeight\": \"375 nm\"}");

        assertRefused("--patch lost.json", "lost.json, line 1", "there is no file lost.png; check the name");
    }

    @Test
    void aDescriptorThatIsNoJson() throws Exception {
        Files.writeString(workplace.resolve("broken.json"), "{\"heights\":");

        assertRefused("--patch broken.json", "broken.json, line 1: no valid JSON");
    }

    private void assertRefused(String options, String... words) throws Exception {
        assertRefused(Complaint.UNUSABLE_INPUT, options, words);
    }

    private void assertRefused(int exitCode, String options, String... words) throws Exception {
        var before = workplace.files();
        String[] arguments = Stream.of(("brdf-map --size 8 --output map.png " + options).split(" ", -1))
                .filter(argument -> !argument.isEmpty())
                .toArray(String[]::new);

        Complaint.assertThatIt(workplace.here(arguments), exitCode, words);

        assertThat(workplace.files()).as("files left").isEqualTo(before);
        assertThat(workplace.tables()).as("tables left").isEmpty();
    }
}
