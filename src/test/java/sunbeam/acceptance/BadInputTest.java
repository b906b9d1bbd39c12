package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.files.output.OutputException;

/** Wrong options, directions, patches and outputs are refused in one line with file or option, value and remedy. */
class BadInputTest extends InWorkplace {
    @BeforeEach
    void layOut() throws IOException {
        Files.writeString(workplace.resolve("in.csv"), "theta_i,phi_i,theta_r,phi_r,wavelength\n0,0,10,180,550\n");
        Images.gray(workplace.resolve("scan.png"), 16, 16, (column, row) -> 13 * column + row);
        Files.writeString(workplace.resolve("notes.png"), "heights: see the other file\n");
        Images.gray(workplace.resolve("one.png"), 1, 1, (column, row) -> 7);
        Files.writeString(
                workplace.resolve("lost.json"),
                "{\"heights\": \"lost.png\", \"width\": \"65 um\", \"maxHeight\": \"375 nm\"}");
        Files.writeString(workplace.resolve("broken.json"), "{\"heights\":");
    }

    /** Asserts one line with all of these words, which are separated by " / ", and neither a file nor a table left. */
    private void assertRefused(int code, String commandLine, String words) throws IOException {
        List<String> before = workplace.files();

        workplace.here(commandLine).complains(code, words.split(" / "));

        assertThat(workplace.files()).as("files left").isEqualTo(before);
        assertThat(workplace.tables()).as("tables left").isEmpty();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            brdf-map --size 0|--size 0 is out of range; give 1 to
            brdf-map --size 100000|--size 100000 is out of range; give 1 to
            brdf-map --exposure -2|--exposure '-2' is neither auto nor a positive number
            brdf-map --terms 0|--terms 0 is out of range; give 1 to
            brdf-map --radius 99|--radius 99 is out of range; give 0 to
            brdf-map --wavelength-step 0nm|--wavelength-step 0 m is out of range; give
            brdf-map --coherence-length 1m|--coherence-length 1 m is out of range; give
            brdf-map --tolerance 0|--tolerance 0 is out of range; give 1e-5 to 1
            brdf-map --tolerance 1e-7|--tolerance 1e-7 is finer than float32 can reach, which is 1e-5
            brdf-map --preset thesis --tolerance 0.1|--tolerance 0.1 contradicts --preset thesis
            brdf-map --anchor floor|anchor floor is of the thesis's bins
            brdf-map --method gem --terms 5|--terms 5 belongs to --method full, nmm or pq, not gem; leave it out
            brdf-map --preset these|--preset "these" is not one of none, thesis
            brdf-map --output map.png --linear map.png|--linear map.png would be linear colors, which its name does not say; end it with .npy
            brdf-map --tolerance 1%|--tolerance "1%" is no number; write 0.01 for that many percent
            brdf-map --average ensembel|is not one of coherent, ensemble (did you mean ensemble?)
            brdf-map --sise 8|unknown option '--sise' (did you mean --size
            reflectance --directions in.csv|missing required option: '--output
            export blaze --format npz --output b.csv|--output
            export blaze --format npz --output b.npz --size many|--size
            export blaze --format npz --output b.npz --theta-max 91|--theta-max
            export blaze --format tiff --output b.npz|--format
            export blaze --format hdf5 --output b.h5|hdf5
            export blaze --format npz --output b.npz --channels rgb|--channels
            export blaze --format html --output b.html --channels rec709|--channels
            export blaze --format npz --output b.npz --channels spectral --bands 500|--bands 500
            export blaze --format npz --output b.npz --channels spectral --illuminant A|--illuminant
            export blaze --format npz --output b.npz --bands 20|--bands
            export blaze --format npz --output b.npz --channels spectral --wavelengths 532nm|--bands
            export blaze --format osl --output b --bands 20|--bands
            export blaze --format bsdf --output b.brdf|--output
            export blaze --format bsdf --output b.bsdf --channels xyz|--channels
            export blaze --format bsdf --output b.bsdf --illuminant A|--illuminant
            brdf-map --patch scan.png --width 0um --max-height 375nm|--width 0 m is out of range; give 1 nm to 1 m
            brdf-map --patch scan.png --width 65m --max-height 375nm|--width 65 m is out of range; give
            brdf-map --patch scan.png --width 65 --max-height 375nm|--width "65" has no unit; write
            brdf-map --patch scan.png --width 65um --height 0um --max-height 375nm|--height 0 m is out of range; give
            brdf-map --patch scan.png --width 65um --max-height 0nm|--max-height 0 m is out of range; give 1 pm to 1 m
            brdf-map --patch scan.png --width 65um --max-height 375m|--max-height 375 m is out of range; give
            brdf-map --patch scan.png --width 65um --max-height 375mm|--max-height 375 mm makes a relief of
            """)
    void optionsAndScales(String commandLine, String words) throws Exception {
        assertRefused(SunbeamResult.USAGE, commandLine, words);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', textBlock = """
            --patch nowhere.png --width 65um --max-height 375nm | --patch nowhere.png is neither a built-in patch nor an existing file; give a
            --patch notes.png --width 65um --max-height 375nm | notes.png is / format that Sunbeam knows / Gwyddion
            --patch one.png --width 65um --max-height 375nm | one.png has 1 x 1 samples / give at least
            --patch scan.png | scan.png / add for example --width 65um and --max-height 375nm
            --patch scan.png --width 65um | scan.png / add for example --max-height 375nm
            --patch scan.png --max-height 375nm | scan.png / add for example --width 65um
            --patch lost.json | lost.json, line 1 / there is no file lost.png; check the name
            --patch broken.json | broken.json, line 1: no valid JSON
            blaze --periodic yes | 'yes' is neither a built-in patch nor an existing file; a name with blanks needs quotes
            """)
    void surfaces(String options, String words) throws Exception {
        assertRefused(SunbeamResult.UNUSABLE_INPUT, "brdf-map " + options + " --size 8", words);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            theta_i,phi_i,theta_r|0,0,0|it has no column phi_r
            theta_i,phi_i,theta_r,phi_r|0,0,95,0|line 2, column theta_r: 95.0 must lie in 0..89.999 degrees
            theta_i,phi_i,theta_r,phi_r|-1,0,0,0|line 2, column theta_i: -1.0 must lie in 0..89.999 degrees
            theta_i,phi_i,theta_r,phi_r|0,1e300,0,0|line 2, column phi_i: 1.0E300 must lie in -36000..36000 degrees
            theta_i,phi_i,theta_r,phi_r,wavelength|0,0,0,0,5.5e-7|column wavelength: 5.5E-7 must lie in 380..780 nm
            theta_i,phi_i,theta_r,phi_r,wavelength|0,0,0,0|line 2: 4 fields, but the header has 5
            theta_i;phi_i;theta_r;phi_r|0;0;0;0|separate columns by commas
            """)
    void directions(String header, String row, String words) throws Exception {
        Files.writeString(workplace.resolve("in.csv"), header + "\n" + row + "\n");
        String commandLine = "reflectance --patch blaze --output out.csv --directions ";
        assertRefused(SunbeamResult.UNUSABLE_INPUT, commandLine + "in.csv", "in.csv / " + words);
        assertRefused(
                SunbeamResult.UNUSABLE_INPUT,
                commandLine + "no.csv",
                "cannot read no.csv: there is no such file; check");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            brdf-map --size 8 --output maps/map.png|cannot write maps/map.png / does not exist; create it first
            brdf-map --size 8 --output .|it is a folder; name a file in it
            brdf-map --size 8 --output /proc/map.png|/proc/map.png
            precompute --output /proc/table.h5|/proc/table.h5
            reflectance --directions in.csv --output /proc/out.csv|/proc/out.csv
            brdf-map --size 8 --output /dev/full|cannot write /dev/full: No space left on device; free some space or
            brdf-map --size 8 --output map.png --linear /dev/full|cannot write /dev/full: No space left on device; free some space or
            reflectance --directions in.csv --output /dev/full|cannot write /dev/full: No space left on device; free some space or
            """)
    void outputs(String commandLine, String words) throws Exception {
        boolean isHere = Stream.of("/proc", "/dev/full")
                .filter(commandLine::contains)
                .allMatch(place -> Files.exists(Path.of(place)));
        assumeTrue(isHere, "skipped: no /proc, where no files can be made, or no /dev/full, which is always full");
        List<String> before = workplace.files();

        // Tables may be in the cache: a full disk shows at the end.
        workplace.here(commandLine + " --patch blaze").complains(SunbeamResult.CANNOT_WRITE, words.split(" / "));

        assertThat(workplace.files()).isEqualTo(before);
    }

    @Test
    void aFolderThatIsWriteProtected() {
        assertThat(OutputException.of(Path.of("map.png"), new AccessDeniedException("map.png")))
                .hasMessage("cannot write map.png: permission denied; choose a folder that you may write to");
    }

    /** The output is checked first: the missing patch would have exit code 4. */
    @ParameterizedTest
    @CsvSource({
        "inspect none.gwy --output taken.png, taken.png",
        "brdf-map --patch none.gwy --output taken.png, taken.png",
        "brdf-map --patch none.gwy --output free.png --linear taken.npy, taken.npy",
        "color --patch none.gwy --output taken.png, taken.png",
        "color --patch none.gwy --output only-the-table.png, only-the-table.csv",
        "evaluate --patch none.gwy --output taken, taken.png",
        "evaluate --patch none.gwy --output taken.csv, taken.png",
        "precompute --patch none.gwy --output taken.h5, taken.h5",
        "benchmark --patch none.gwy --output taken.md, taken.md",
        "reflectance --patch none.gwy --directions in.csv --output taken.csv, taken.csv",
        "export none.gwy --format npz --output taken.npz, taken.npz",
        "export none.gwy --format glsl --output ., ./sunbeam.exr"
    })
    void anOutputThatExistsIsRefusedBeforeThePatchIsRead(String commandLine, String taken) throws Exception {
        Files.createFile(workplace.resolve(taken));
        assertRefused(SunbeamResult.OUTPUT_EXISTS, commandLine, "cannot write " + taken + ": it exists; add --force");
    }

    /** The system refuses to let a file grow beyond 8 MB: the picture fits, the 12 MB of linear colors do not. */
    @Test
    void aDiskThatFillsUpWhileTheSecondFileIsWritten() throws Exception {
        List<String> before = workplace.files();
        // The first start after a build writes an archive of Java's classes, which is larger than 8 MB, too.
        workplace.command("--version").run().ended(0);
        // Blocks of 1024 bytes.
        SunbeamResult result = workplace
                .commandBy(
                        "ulimit -f 8192; exec $SUNBEAM",
                        "brdf-map --patch blaze --size 1024 --tolerance 0.1 --output a.png --linear a.npy")
                .run();

        result.complains(SunbeamResult.CANNOT_WRITE, "cannot write a.npy: File too large; choose another");
        assertThat(workplace.files()).isEqualTo(before);
    }
}
