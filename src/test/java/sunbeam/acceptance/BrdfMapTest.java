package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.input.PngText;

/** Output files of {@code brdf-map}. */
class BrdfMapTest extends InWorkplace {
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
}
