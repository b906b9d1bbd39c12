package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.input.PngText;

class OutputTest extends InWorkplace {
    @Test
    void withoutAnyChoiceItDrawsTheDefaultPatchAndSaysWhere() throws Exception {
        SunbeamResult result = workplace.succeed("brdf-map --size 48 --no-annotate");

        assertThat(result.stdout()).isEqualTo("brdf-elaphe-like.png\n");
        assertThat(result.stderr()).startsWith("plan: ");
        assertThat(result.complaints()).isEmpty();
        assertThat(workplace.files()).containsExactly("brdf-elaphe-like.png");
        var picture = ImageIO.read(workplace.resolve("brdf-elaphe-like.png").toFile());
        assertThat(picture.getWidth()).isEqualTo(48);
        assertThat(picture.getHeight()).isEqualTo(48);
        // The cache holds the patch's heights besides the table.
        assertThat(workplace.tables())
                .filteredOn(file -> file.toString().endsWith(".tables"))
                .hasSize(1);
    }

    @Test
    void thePictureSaysHowItWasMadeAndTheLinearColorsKnowNoExposure() throws Exception {
        String blaze = "brdf-map --patch blaze --size 9 --no-annotate --theta-i 20 --exposure ";
        workplace.succeedHere(blaze + "2.5 --output dim.png --linear dim.npy");
        workplace.succeedHere(blaze + "1e6 --output lit.png --linear lit.npy");

        assertThat(PngText.read(workplace.resolve("dim.png")))
                .containsEntry("Title", "BRDF map of blaze")
                .containsEntry("Method", "full")
                .containsEntry("Exposure", "2.5")
                .containsKeys("Software", "Patch", "Plan", "Renderer")
                .hasEntrySatisfying("Light", light -> assertThat(light).isEqualTo("theta 20, phi 0 degrees"));
        assertThat(workplace.resolve("lit.npy")).hasSameBinaryContentAs(workplace.resolve("dim.npy"));
        assertThat(brightness("lit.png")).isGreaterThan(brightness("dim.png"));
    }

    private long brightness(String name) throws IOException {
        var image = ImageIO.read(workplace.resolve(name).toFile());
        long sum = 0;
        for (int i = 0; i < image.getWidth() * image.getHeight(); i++) {
            sum += image.getRGB(i % image.getWidth(), i / image.getWidth()) & 0xff;
        }
        return sum;
    }

    @Test
    @Tag("thorough")
    void eachOfEightProgramsAtOnceHasItsOutputAndOneTableIsLeft() throws Exception {
        List<RunningSunbeam> programs = new ArrayList<>();
        try {
            for (int i = 0; i < 8; i++) {
                programs.add(
                        workplace.command("brdf-map --patch lamellar --size 16").start());
            }
            Set<String> outputs = new TreeSet<>();
            for (RunningSunbeam program : programs) {
                SunbeamResult result = program.end(Duration.ofMinutes(5)).ended(0);
                outputs.add(result.stdout().lines().reduce((one, last) -> last).orElseThrow());
            }
            assertThat(outputs).hasSize(8).contains("brdf-lamellar.png", "brdf-lamellar-8.png");
            assertThat(workplace.files()).containsExactlyElementsOf(outputs);
            // The cache has one table and no unfinished file.
            assertThat(workplace.tables().stream()
                            .filter(file -> file.toString().endsWith(".tables")))
                    .hasSize(1);
            assertThat(workplace.tables().stream()
                            .filter(file -> file.toString().endsWith(".part")))
                    .isEmpty();
        } finally {
            for (RunningSunbeam program : programs) {
                program.close();
            }
        }
    }

    @Test
    void aFileOfTheNameMinusIsStandardOutputAndReportsGoElsewhere() throws Exception {
        // Meshes need no graphics, so that a display which does not answer is no fault.
        SunbeamResult result = workplace
                .command("mesh plane --output -")
                .with("DISPLAY", ":9876")
                .run()
                .ended(0);
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
