package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What goes to the standard output of the real program. */
class StandardOutputTest {
    @TempDir
    Path root;

    private Workplace workplace;

    @BeforeEach
    void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    @Test
    void aFileOfTheNameMinusIsStandardOutputAndReportsGoElsewhere() throws Exception {
        SunbeamResult result = workplace.succeed("mesh", "plane", "--output", "-");

        assertThat(result.stdout().lines())
                .hasSizeGreaterThan(128)
                .allMatch(line -> line.matches("(#|v|vt|vn|f) .*"), "of an OBJ file");
        assertThat(result.stderr()).contains("128 triangles").hasLineCount(1);
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void aReportThatADiskHasNoRoomForIsAFailure() throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/full")), "skipped: no /dev/full, the disk that is always full");
        Path launcher = root.resolve("into-a-full-disk");
        Files.writeString(
                launcher, "#!/bin/sh\nexec '" + Sunbeam.repository().resolve("sunbeam") + "' \"$@\" > /dev/full\n");
        assertThat(launcher.toFile().setExecutable(true)).isTrue();

        SunbeamResult result = workplace
                .equip(Sunbeam.launcher(launcher, "inspect", "--patch", "blaze", "--output", "a.png"))
                .run();

        Complaint.assertThatIt(result, Complaint.CANNOT_WRITE, "cannot write to standard output");
    }
}
