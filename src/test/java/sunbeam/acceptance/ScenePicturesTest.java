package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.color.CieLab;

/**
 * Compares pictures of built-in scenes with those of an earlier version in the test resources. Differences are CIE 1976's, by pixels of the
 * PNG.
 */
class ScenePicturesTest extends InOneWorkplace {
    @BeforeAll
    static void layOut() throws IOException {
        Files.copy(resource("three-lights.json"), workplace.resolve("three-lights.json"));
    }

    private static Path resource(String name) {
        return SharedData.present("sunbeam/acceptance/contract/" + name);
    }

    private static BufferedImage render(String options) throws IOException {
        workplace.succeedHere("render --size 160x120 --output picture.png --force " + options);
        return ImageIO.read(workplace.resolve("picture.png").toFile());
    }

    /** Returns CIE 1976's differences of all pixels, ascending. */
    private static double[] differences(BufferedImage picture, String reference) throws IOException {
        BufferedImage expected = ImageIO.read(resource(reference + ".png").toFile());
        assertThat(picture.getWidth()).isEqualTo(expected.getWidth());
        assertThat(picture.getHeight()).isEqualTo(expected.getHeight());
        double[] all = new double[picture.getWidth() * picture.getHeight()];
        for (int i = 0; i < all.length; i++) {
            int x = i % picture.getWidth();
            int y = i / picture.getWidth();
            CieLab one = CieLab.ofSrgb(picture.getRGB(x, y));
            CieLab other = CieLab.ofSrgb(expected.getRGB(x, y));
            all[i] = Math.hypot(
                    one.lightness() - other.lightness(), Math.hypot(one.a() - other.a(), one.b() - other.b()));
        }
        Arrays.sort(all);
        return all;
    }

    /**
     * In 98 of 100 pixels differences are below what side by side is just noticed (Mahy, Van Eycken and Oosterlinck 1994: 2.3): glints
     * of a pixel's width are sampled, and may move. With one sample a pixel a color's own sampling error is ten times as large (mean 1.6
     * beside 64 samples), so glints differ in more pixels.
     */
    @ParameterizedTest
    @CsvSource({
        "elaphe, elaphe, 2.3",
        "xenopeltis, xenopeltis, 2.3",
        "light-above, light-above, 2.3",
        "elaphe-scales --supersample 2, elaphe-scales, 2.3",
        "three-lights.json --supersample 2, three-lights, 2.3",
        "xenopeltis --method full --preset thesis --supersample 1, xenopeltis-thesis, 2.3",
        "elaphe --supersample 1, elaphe-one-sample, 6"
    })
    void aSceneLooksAsBefore(String options, String reference, double rarelyExceeded) throws IOException {
        double[] differences = differences(render(options), reference);
        assertThat(Arrays.stream(differences).average().orElseThrow())
                .as("mean difference to %s", reference)
                // Half of a just visible difference (1.0).
                .isLessThan(0.5);
        assertThat(differences[(int) (0.98 * differences.length)])
                .as("98th percentile of the difference to %s", reference)
                .isLessThan(rarelyExceeded);
    }

    private static final String PLANE = """
            {
              "mesh": "plane",
              "patch": "blaze",
              "camera": { "position": ["-5 cm", "-10 cm", "40 cm"], "lookAt": ["0 m", "0 m", "0 m"] },
              "light": { "direction": [-0.2, 0.3, 0.9] },
              "texture": "none",
              "weights": { "diffraction": 30, "texture": 0.2, "ambient": 0.1 }
            }
            """;

    private float[] linear(String scene, String options) throws IOException {
        Files.writeString(workplace.resolve("scene.json"), scene);
        int code = workplace
                .here("render scene.json --method full --tolerance 0.1 --size 24x24 --force --output plane.png"
                        + " --linear plane.npy" + options)
                .exitCode();
        // 3: less than 5 % of the mesh is lit.
        assertThat(code).isIn(0, 3);
        float[] values = NpyImage.read(workplace.resolve("plane.npy"), 24).values();
        for (float value : values) {
            // Pixels without the mesh have no radiance.
            assertThat(Float.isNaN(value) || (value >= 0 && value < 1e6))
                    .as("radiance %s", value)
                    .isTrue();
        }
        return values;
    }

    @Test
    void twiceTheLightIsTwiceTheRadianceAndExposureChangesNothing() throws Exception {
        float[] once = linear(PLANE, "");
        float[] twice =
                linear(PLANE.replace("\"direction\": [", "\"intensity\": 2, \"direction\": ["), " --exposure 0.3");

        int[] lit = IntStream.range(0, once.length).filter(i -> once[i] > 0).toArray();
        assertThat(lit).isNotEmpty();
        for (int i : lit) {
            // Rounding of float32 sums.
            assertThat((double) twice[i]).isBetween(1.9999 * once[i], 2.0001 * once[i]);
        }
    }

    private static final String MIRROR = """
            {
              "mesh": "plane",
              "patch": "blaze",
              "camera": { "position": ["%s cm", "0 cm", "40 cm"], "lookAt": ["0 m", "0 m", "0 m"], "fieldOfView": "0.1 deg", "up": [0, 1, 0] },
              "light": { "direction": [-0.5, 0, 1] },
              "texture": "none",
              "sky": %s,
              "weights": { "diffraction": 0, "texture": 1e-6 }
            }
            """;

    /** The reflectance of a glossy skin is 0.04 for this angle of 27 degrees, its slopes have a variance of 0.0036. */
    @Test
    void aSkinUnderASkyMirrorsTheLightInItsOwnColor() throws Exception {
        float[] mirrored = linear(MIRROR.formatted("20", "1e-6"), "");
        double cosine = 1 / Math.hypot(0.5, 1);
        // D65, and the density of the slope 0 of the microfacets; in 0.1 degrees the view does not change.
        assertThat((double) mirrored[1]).isCloseTo(0.04 / (8 * 0.0036 * cosine), withinPercentage(1));
        assertThat((double) mirrored[0] / mirrored[1]).isCloseTo(0.9505, withinPercentage(0.2));
        assertThat((double) mirrored[2] / mirrored[1]).isCloseTo(1.0891, withinPercentage(0.2));
        // The body alone.
        assertThat(linear(MIRROR.formatted("20", "0"), "")[1]).isLessThan(1e-5f);
        // A slope of 13 degrees would mirror: 4 deviations.
        assertThat(linear(MIRROR.formatted("0", "1e-6"), "")[1]).isLessThan(1e-3f * mirrored[1]);
    }

    /** On the plane, of 20 cm, the texture's eye is 1.9 mm long and 17 mm wide. */
    @Test
    void anEyeDiffractsNothing() throws Exception {
        String scene = """
                {
                  "mesh": "plane",
                  "patch": "blaze",
                  "camera": { "position": ["%1$s cm", "3.2 cm", "40 cm"], "lookAt": ["%1$s cm", "3.2 cm", "0 m"], "fieldOfView": "0.05 deg", "up": [0, 1, 0] },
                  "light": { "direction": [0, 0, 1] },
                  "texture": "elaphe",
                  "weights": { "diffraction": 30, "texture": 0 }
                }
                """;
        assertThat(linear(scene.formatted("-9.568"), "")[1]).isZero();
        assertThat(linear(scene.formatted("-9"), "")[1]).isPositive();
    }
}
