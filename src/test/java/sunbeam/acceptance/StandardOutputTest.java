package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
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

    /** Java warns on standard output about a class archive that was made for another folder. */
    @Test
    void aPictureFromACopiedCheckoutIsAPicture() throws Exception {
        workplace.succeed("--version");
        Path checkout = Files.createDirectory(root.resolve("copied"));
        Process copying = new ProcessBuilder(
                        "cp", "-r", "--parents", "sunbeam", "app/target", "data", "shaders", checkout.toString())
                .directory(Sunbeam.repository().toFile())
                .inheritIO()
                .start();
        assertThat(copying.waitFor()).isZero();
        Path png = root.resolve("copied.png");
        ProcessBuilder start = new ProcessBuilder(
                checkout.resolve("sunbeam").toString(), "inspect", "--patch", "blaze", "--output", "-");
        start.environment().put("SUNBEAM_NO_BUILD", "1");
        for (int i = 0; i < 2; i++) {
            Process process = start.redirectOutput(png.toFile()).start();
            String said = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(process.waitFor()).as(said).isZero();
            assertThat(said).doesNotContain("archive");
            assertThat(ImageIO.read(png.toFile())).as("a picture").isNotNull();
            assertThat(Files.readAllBytes(png)).startsWith((byte) 0x89, 'P', 'N', 'G');
        }
        try (Stream<Path> archives =
                Files.find(checkout.resolve("app/target/run"), 2, (file, of) -> file.endsWith("classes.jsa"))) {
            assertThat(archives).as("made anew in its place, the old one gone").hasSize(1);
        }
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
