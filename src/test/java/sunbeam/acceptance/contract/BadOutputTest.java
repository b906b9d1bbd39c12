package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.SunbeamResult;
import sunbeam.app.files.output.OutputException;

class BadOutputTest extends InWorkplace {
    @ParameterizedTest
    @CsvSource({
        "brdf-map --size 8 --output, map.png",
        "precompute --output, table.h5",
        "reflectance --directions in.csv --output, out.csv"
    })
    void aFolderThatTakesNoFiles(String commandLine, String name) throws Exception {
        assumeTrue(Files.isDirectory(Path.of("/proc")), "skipped: no /proc, where nobody may make files");
        writeDirections();

        Complaint.assertThatIt(run(commandLine + " /proc/" + name), Complaint.CANNOT_WRITE, "/proc/" + name);
    }

    @Test
    void aFolderThatIsWriteProtected() {
        assertThat(OutputException.of(Path.of("map.png"), new AccessDeniedException("map.png")))
                .hasMessage("cannot write map.png: permission denied; choose a folder that you may write to");
    }

    @Test
    void aFolderThatIsNotThere() throws Exception {
        Complaint.assertThatIt(
                run("brdf-map --size 8 --output maps/map.png"),
                Complaint.CANNOT_WRITE,
                "cannot write maps/map.png",
                "does not exist; create it first");
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void aFolderInPlaceOfAFile() throws Exception {
        Complaint.assertThatIt(
                run("brdf-map --size 8 --output ."), Complaint.CANNOT_WRITE, "it is a folder; name a file in it");
        assertThat(workplace.files()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "brdf-map --size 8 --output",
        "brdf-map --size 8 --output map.png --linear",
        "reflectance --directions in.csv --output"
    })
    void aFullDisk(String commandLine) throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/full")), "skipped: no /dev/full, the disk that is always full");
        writeDirections();

        Complaint.assertThatIt(
                run(commandLine + " /dev/full"),
                Complaint.CANNOT_WRITE,
                "cannot write /dev/full: No space left on device; free some space or choose another folder");
        assertThat(workplace.files()).containsExactly("in.csv");
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
        writeDirections();
        Files.createFile(workplace.resolve(taken));
        List<String> before = workplace.files();

        Complaint.assertThatItExists(workplace.here(commandLine), taken);
        assertThat(workplace.files()).isEqualTo(before);
    }

    /** The system refuses to let a file grow beyond 8 MB: the picture fits, the 12 MB of linear colors do not. */
    @Test
    void aDiskThatFillsUpWhileTheSecondFileIsWritten() throws Exception {
        // Blocks of 1024 bytes.
        SunbeamResult result = workplace
                .commandBy(
                        "ulimit -f 8192; exec $SUNBEAM",
                        "brdf-map --patch blaze --size 1024 --tolerance 0.1 --output a.png --linear a.npy")
                .run();

        Complaint.assertThatIt(result, Complaint.CANNOT_WRITE, "cannot write a.npy: File too large; choose another");
        assertThat(workplace.files()).isEmpty();
    }

    private void writeDirections() throws IOException {
        Files.writeString(workplace.resolve("in.csv"), "theta_i,phi_i,theta_r,phi_r,wavelength\n0,0,10,180,550\n");
    }

    private SunbeamResult run(String commandLine) throws IOException {
        return workplace.here(commandLine + " --patch blaze");
    }
}
