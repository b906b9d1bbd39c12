package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.Images;
import sunbeam.acceptance.InWorkplace;

/** Unusable surfaces are reported in one line with file or option, value and remedy. */
class BadPatchTest extends InWorkplace {
    private static final String SCALE = " --width 65um --max-height 375nm";

    @BeforeEach
    void layOut() throws IOException {
        Images.gray(workplace.resolve("scan.png"), 16, 16, (column, row) -> 13 * column + row);
        Files.writeString(workplace.resolve("notes.png"), "heights: see the other file\n");
        Images.gray(workplace.resolve("one.png"), 1, 1, (column, row) -> 7);
        Files.writeString(
                workplace.resolve("lost.json"),
                "{\"heights\": \"lost.png\", \"width\": \"65 um\", \"maxHeight\": \"375 nm\"}");
        Files.writeString(workplace.resolve("broken.json"), "{\"heights\":");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "nowhere.png | --patch nowhere.png is neither a built-in patch nor an existing file; give a",
                "notes.png | notes.png is / format that Sunbeam knows / Gwyddion",
                "one.png | one.png has 1 x 1 samples / give at least"
            })
    void aFileThatIsNoSurface(String patch, String words) throws Exception {
        assertRefused(Complaint.UNUSABLE_INPUT, "--patch " + patch + SCALE, words);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "scan.png | scan.png / add for example --width 65um and --max-height 375nm",
                "scan.png --width 65um | scan.png / add for example --max-height 375nm",
                "scan.png --max-height 375nm | scan.png / add for example --width 65um",
                "lost.json | lost.json, line 1 / there is no file lost.png; check the name",
                "broken.json | broken.json, line 1: no valid JSON"
            })
    void aSurfaceThatIsNotDescribed(String patch, String words) throws Exception {
        assertRefused(Complaint.UNUSABLE_INPUT, "--patch " + patch, words);
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
        "--width 65um --max-height 375mm, '--max-height 375 mm makes a relief of'"
    })
    void aScaleThatCannotBe(String options, String words) throws Exception {
        assertRefused(Complaint.USAGE, "--patch scan.png " + options, words);
    }

    @Test
    void aWordThatNamesNoSurface() throws Exception {
        Complaint.assertThatIt(
                workplace.here("brdf-map blaze --periodic yes"),
                Complaint.UNUSABLE_INPUT,
                "'yes' is neither a built-in patch nor an existing file; a name with blanks needs quotes");
    }

    private void assertRefused(int exitCode, String options, String words) throws Exception {
        var before = workplace.files();

        Complaint.assertThatIt(
                workplace.here("brdf-map --size 8 --output map.png " + options), exitCode, words.split(" / "));

        assertThat(workplace.files()).as("files left").isEqualTo(before);
        assertThat(workplace.tables()).as("tables left").isEmpty();
    }
}
