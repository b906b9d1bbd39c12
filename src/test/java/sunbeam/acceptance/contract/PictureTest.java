package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.NpyImage;

/** Linear colors of scenes by two methods, and their brightness. */
class PictureTest extends InWorkplace {
    private static final int SIDE = 24;
    private static final String SCENE = """
            {
              "mesh": "plane",
              "patch": "blaze",
              "camera": { "position": ["-5 cm", "-10 cm", "40 cm"], "lookAt": ["0 m", "0 m", "0 m"] },
              "light": { "direction": [-0.2, 0.3, 0.9] },
              "texture": "none",
              "weights": { "diffraction": 30, "texture": 0.2, "ambient": 0.1 }
            }
            """;

    @BeforeEach
    void layOut() throws IOException {
        Files.writeString(workplace.resolve("scene.json"), SCENE);
    }

    private NpyImage render(String name, String options) throws IOException {
        workplace.succeedHere("render scene.json --size 24x24 --output %s.png --linear %s.npy " + options, name, name);
        NpyImage image = NpyImage.read(workplace.resolve(name + ".npy"), SIDE);
        for (float value : image.values()) {
            // Pixels without the mesh have no radiance.
            assertThat(Float.isNaN(value) || (value >= 0 && value < 1e6))
                    .as("radiance %s", value)
                    .isTrue();
        }
        return image;
    }

    private static double sum(NpyImage image) {
        double sum = 0;
        for (float value : image.values()) {
            sum += Float.isNaN(value) ? 0 : value;
        }
        return sum;
    }

    @Test
    void twoMethodsDrawTheSamePicture() throws Exception {
        NpyImage full = render("full", "--method full --tolerance 1e-2");
        NpyImage table = render("table", "--method table --tolerance 1e-2");

        assertThat(sum(full)).isPositive();
        double brightest = 0;
        List<Double> errors = new ArrayList<>();
        for (int i = 0; i < full.values().length; i++) {
            brightest = Float.isNaN(full.values()[i]) ? brightest : Math.max(brightest, full.values()[i]);
        }
        for (int i = 0; i < full.values().length; i++) {
            double value = full.values()[i];
            // At the mesh's edge one method samples the pixel's center, the other its area.
            if (value > 1e-3 * brightest && !Float.isNaN(table.values()[i])) {
                errors.add(Math.abs(table.values()[i] - value) / value);
            }
        }
        assertThat(errors).hasSizeGreaterThan(SIDE * SIDE / 2);
        Collections.sort(errors);
        // Each method keeps 0.01 in the median and 0.03 in 95 %; a channel may be a tenth of the largest.
        assertThat(errors.get(errors.size() / 2)).as("median").isLessThan(2e-2);
        assertThat(errors.get((int) (0.95 * (errors.size() - 1)))).as("95 %%").isLessThan(0.1);
    }

    @Test
    void twiceTheLightIsTwiceTheRadianceAndExposureChangesNothing() throws Exception {
        NpyImage once = render("once", "--method full --tolerance 0.1");
        Files.writeString(
                workplace.resolve("scene.json"),
                SCENE.replace("\"direction\": [", "\"intensity\": 2, \"direction\": ["));
        NpyImage twice = render("twice", "--method full --tolerance 0.1 --exposure 0.3");

        assertThat(sum(once)).isPositive();
        for (int i = 0; i < once.values().length; i++) {
            if (Float.isNaN(once.values()[i])) {
                continue;
            }
            // Rounding of float32 sums.
            assertThat((double) twice.values()[i]).isBetween(1.9999 * once.values()[i], 2.0001 * once.values()[i]);
        }
    }
}
