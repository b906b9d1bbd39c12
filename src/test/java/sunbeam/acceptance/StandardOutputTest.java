package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Standard output of the real program. */
class StandardOutputTest extends InWorkplace {
    @Test
    void aFileOfTheNameMinusIsStandardOutputAndReportsGoElsewhere() throws Exception {
        // Meshes need no graphics, so that a display which does not answer is no fault.
        SunbeamResult result = workplace
                .command("mesh plane --output -")
                .with("DISPLAY", ":9876")
                .run();

        assertThat(result.exitCode()).as("%s", result).isZero();
        assertThat(result.stdout().lines())
                .hasSizeGreaterThan(128)
                .allMatch(line -> line.matches("(#|v|vt|vn|f) .*"), "of an OBJ file");
        assertThat(result.stderr()).contains("128 triangles").hasLineCount(1);
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void aPipeThatIsClosedIsALineThatSaysSo() throws Exception {
        SunbeamResult result = workplace
                .commandBy("$SUNBEAM > >(exec true)", "inspect --patch blaze --output - --quiet")
                .run();

        Complaint.assertThatIt(result, Complaint.CANNOT_WRITE, "the program that reads it has ended");
        assertThat(result.stderr()).doesNotContain("another folder");
    }
}
