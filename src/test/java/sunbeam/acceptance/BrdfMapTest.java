package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** Output files of {@code brdf-map}. */
class BrdfMapTest extends InWorkplace {
    @Test
    void withoutAnyChoiceItDrawsTheDefaultPatchAndSaysWhere() throws Exception {
        SunbeamResult result = workplace.succeed("brdf-map", "--size", "48", "--no-annotate");

        assertThat(result.stdout()).isEqualTo("brdf-elaphe-like.png\n");
        // A busy machine may be slow enough for a line of progress.
        assertThat(result.stderr().lines().filter(line -> !line.contains(" %, ")))
                .singleElement()
                .asString()
                .startsWith("plan: ");
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
        blaze(
                "--size",
                "9",
                "--no-annotate",
                "--theta-i",
                "20",
                "--exposure",
                "2.5",
                "--output",
                "dim.png",
                "--linear",
                "dim.npy");
        blaze(
                "--size",
                "9",
                "--no-annotate",
                "--theta-i",
                "20",
                "--exposure",
                "1e6",
                "--output",
                "lit.png",
                "--linear",
                "lit.npy");

        assertThat(PngFile.text(workplace.resolve("dim.png")))
                .containsEntry("Title", "BRDF map of blaze")
                .containsEntry("Method", "full")
                .containsEntry("Exposure", "2.5")
                .containsKeys("Software", "Patch", "Plan", "Renderer")
                .hasEntrySatisfying("Light", light -> assertThat(light).isEqualTo("theta 20, phi 0 degrees"));
        assertThat(workplace.resolve("lit.npy")).hasSameBinaryContentAs(workplace.resolve("dim.npy"));
        assertThat(brightness("lit.png")).isGreaterThan(brightness("dim.png"));
    }

    private SunbeamResult blaze(String... options) throws IOException {
        String[] arguments = new String[options.length + 3];
        System.arraycopy(new String[] {"brdf-map", "--patch", "blaze"}, 0, arguments, 0, 3);
        System.arraycopy(options, 0, arguments, 3, options.length);
        return workplace.succeedHere(arguments);
    }

    private long brightness(String name) throws IOException {
        var image = ImageIO.read(workplace.resolve(name).toFile());
        long sum = 0;
        for (int i = 0; i < image.getWidth() * image.getHeight(); i++) {
            sum += image.getRGB(i % image.getWidth(), i / image.getWidth()) & 0xff;
        }
        return sum;
    }
}
