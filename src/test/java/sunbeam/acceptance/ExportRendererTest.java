package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Materials for Mitsuba and Cycles made of exported tables. */
class ExportRendererTest extends InOneWorkplace {
    private static final String SURFACE = "--samples 0 --coherence-length 16um";

    @BeforeAll
    static void export() throws IOException {
        workplace.succeedHere("export blaze --format osl --output osl --size 5MB " + SURFACE);
    }

    /** The script fails if samples do not have their density (level 0.01), light is lost, or NumPy reads other colors. */
    @Test
    void mitsubaDrawsDirectionsFromTheTable() throws Exception {
        OtherPrograms.requireMitsuba();
        workplace.succeedHere("export blaze --format npz --output b.npz --samples 0 --size 5MB");

        assertThat(OtherPrograms.python(workplace.folder(), Sunbeam.example("mitsuba_bsdf.py"), "b.npz"))
                .containsPattern("5 degrees: chi-square p 0\\.\\d+; white furnace");
    }

    @Test
    void aShaderForRenderersComesWithItsTableAlone() throws Exception {
        try (Stream<Path> files = Files.list(workplace.resolve("osl"))) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .contains("sunbeam.osl", "sunbeam.exr", "sunbeam.md", "sunbeam.json")
                    .noneMatch(name -> name.endsWith(".ktx2") || name.endsWith(".html"));
        }
        assertThat(workplace.resolve("osl/sunbeam.osl")).content().doesNotContainPattern("@[A-Z_]+@");
        assertThat(workplace.resolve("osl/sunbeam.md")).content().doesNotContainPattern("@[A-Z_]+@");
    }

    /** The picture under a sun is the function's value but for the noise of Cycles' sampling: 0.2 at 64 samples. */
    @Test
    void cyclesReflectsWhatTheShaderSays() throws Exception {
        OtherPrograms.requirePython("bpy");

        String said = OtherPrograms.python(
                workplace.folder(), Sunbeam.example("blender_material.py"), "osl", "spheres.png", "48", "64");

        Matcher light =
                Pattern.compile("drawn ([0-9.e-]+), as a color ([0-9.e-]+)").matcher(said);
        assertThat(light.find()).as(said).isTrue();
        assertThat(said).containsPattern("\\d+ % noise at 64 samples");
        double color = Double.parseDouble(light.group(2));
        assertThat(color).isPositive();
        assertThat(Double.parseDouble(light.group(1))).isCloseTo(color, Offset.offset(0.2 * color));
        assertThat(ImageIO.read(workplace.resolve("spheres.png").toFile()).getWidth())
                .isEqualTo(2 * 48);
    }
}
