package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.input.PngText;

/** Outputs of the real program, also when it is ended while it works. That {@code --resume} goes on is tested command by command. */
class OutputTest extends InWorkplace {
    @Test
    void withoutAnyChoiceItDrawsTheDefaultPatchAndSaysWhere() throws Exception {
        SunbeamResult result =
                workplace.command("brdf-map --size 48 --no-annotate").run().ended(0);

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

    @Test
    void aPictureIsTheSameOnAMachineWithoutAnyFont() throws Exception {
        workplace.command("inspect blaze --output here.png").run().ended(0);
        // Java keeps a list of the system's fonts in the user's home.
        Path home = Files.createDirectory(workplace.resolve("home"));
        Path fonts = Files.writeString(home.resolve("fonts.conf"), "<fontconfig/>");
        workplace
                .command("inspect blaze --output there.png")
                .with("HOME", home.toString())
                .with("FONTCONFIG_FILE", fonts.toString())
                .run()
                .ended(0);
        assertThat(workplace.resolve("there.png")).hasSameBinaryContentAs(workplace.resolve("here.png"));
    }

    private long brightness(String name) throws IOException {
        var image = ImageIO.read(workplace.resolve(name).toFile());
        return IntStream.of(image.getRGB(0, 0, 9, 9, null, 0, 9))
                .map(rgb -> rgb & 0xff)
                .sum();
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
            assertThat(workplace.tables())
                    .noneMatch(file -> file.toString().endsWith(".part"))
                    .filteredOn(file -> file.toString().endsWith(".tables"))
                    .hasSize(1);
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

        result.complains(SunbeamResult.CANNOT_WRITE, "the program that reads it has ended");
        assertThat(result.stderr()).doesNotContain("another folder");
    }

    private SunbeamResult interrupt(String commandLine, Callable<Boolean> hasBegun) throws Exception {
        try (RunningSunbeam running = workplace.command(commandLine).start()) {
            RunningSunbeam.await("the first result", hasBegun);
            running.signal("INT");
            SunbeamResult result = running.end(Duration.ofSeconds(30)).ended(SunbeamResult.INTERRUPTED);
            assertThat(result.stdout()).isEmpty();
            return result;
        }
    }

    /** True a second after the tables are in the cache, which are written before the drawing starts. */
    private boolean isDrawing() throws Exception {
        boolean hasTable =
                workplace.tables().stream().anyMatch(table -> table.toString().endsWith(".tables"));
        Thread.sleep(hasTable ? 1000 : 0);
        return hasTable;
    }

    @Test
    void aMapLeavesNothingAndSaysNothing() throws Exception {
        // Drawing takes hours.
        SunbeamResult result =
                interrupt("brdf-map --patch blaze --size 8192 --output a.png --linear a.npy", this::isDrawing);

        assertThat(result.stderr()).startsWith("plan: ").hasLineCount(1);
        assertThat(workplace.files()).isEmpty();
        assertThat(workplace.tables()).allMatch(table -> table.toString().endsWith(".tables"));
    }

    @Test
    void aFolderOfScansKeepsTheFinishedReports() throws Exception {
        Path scans = Files.createDirectory(workplace.resolve("scans"));
        for (int i = 0; i < 40; i++) {
            Images.gray(scans.resolve("scan" + i + ".png"), 64, 64, (column, row) -> column % 8 < 4 ? 0 : 200);
        }
        Path reports = workplace.resolve("report/reports.jsonl");

        SunbeamResult result =
                interrupt("inspect scans --width 16um --max-height 100nm --output report", () -> Files.exists(reports));

        assertThat(result.complaints()).hasLineCount(1).contains("add --resume");
        assertThat(Files.readAllLines(reports)).hasSizeBetween(1, 39);
        assertThat(workplace.resolve("report/table.csv")).doesNotExist();
    }

    @Test
    @Tag("thorough")
    void anAnimationKeepsTheFinishedFrames() throws Exception {
        // With supersampling a frame takes long enough to be interrupted.
        SunbeamResult result = interrupt(
                "render xenopeltis --size 96x72 --supersample 4 --light-sweep 0:90 --frames 12 --output sweep",
                () -> Files.exists(workplace.resolve("sweep/frame-0001.png")));

        assertThat(result.complaints()).hasLineCount(1).contains("add --resume");
        assertThat(workplace.files()).containsExactly("sweep");
        assertThat(workplace.resolve("sweep").toFile().list())
                .hasSizeBetween(1, 11)
                .allMatch(name -> name.matches("frame-\\d{4}\\.png"));
    }
}
