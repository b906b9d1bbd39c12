package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Workplace;

/**
 * Compares pictures of built-in scenes with those of an earlier version in the test resources. Differences are CIE 1976's, by pixels of the
 * PNG.
 */
class ScenePicturesTest {
    // Mean over all pixels: half of a just visible difference (1.0).
    private static final double MEAN = 0.5;
    // What side by side is just noticed (Mahy, Van Eycken and Oosterlinck 1994: 2.3), in 98 of 100 pixels: glints of a
    // pixel's width are sampled, and may move.
    private static final double RARELY_EXCEEDED = 2.3;
    // One sample a pixel: a color's own sampling error is ten times as large (mean 1.6 beside 64 samples), so glints
    // differ in more pixels.
    private static final double RARELY_EXCEEDED_BY_ONE_SAMPLE = 6;

    @TempDir
    static Path root;

    // Scenes of one patch share its tables.
    private static Workplace workplace;

    @BeforeAll
    static void layOut() throws IOException {
        workplace = Workplace.in(root);
        try (InputStream scene = resource("three-lights.json")) {
            Files.copy(scene, workplace.resolve("three-lights.json"), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static InputStream resource(String name) {
        return ScenePicturesTest.class.getResourceAsStream("/sunbeam/acceptance/contract/" + name);
    }

    private static BufferedImage render(String... words) throws IOException {
        List<String> all = new ArrayList<>(List.of("render"));
        all.addAll(List.of(words));
        all.addAll(List.of("--size", "160x120", "--output", "picture.png", "--force"));
        workplace.succeedHere(all.toArray(String[]::new));
        return ImageIO.read(workplace.resolve("picture.png").toFile());
    }

    /** Returns CIE 1976's differences of all pixels, ascending. */
    private static double[] differences(BufferedImage picture, String reference) throws IOException {
        BufferedImage expected;
        try (InputStream file = resource(reference + ".png")) {
            expected = ImageIO.read(file);
        }
        assertThat(picture.getWidth()).isEqualTo(expected.getWidth());
        assertThat(picture.getHeight()).isEqualTo(expected.getHeight());
        double[] all = new double[picture.getWidth() * picture.getHeight()];
        for (int i = 0; i < all.length; i++) {
            int x = i % picture.getWidth();
            int y = i / picture.getWidth();
            double[] one = lab(picture.getRGB(x, y));
            double[] other = lab(expected.getRGB(x, y));
            all[i] = Math.hypot(one[0] - other[0], Math.hypot(one[1] - other[1], one[2] - other[2]));
        }
        Arrays.sort(all);
        return all;
    }

    /** Returns CIE L*a*b* of sRGB. */
    private static double[] lab(int rgb) {
        double r = linear(rgb >> 16 & 0xff);
        double g = linear(rgb >> 8 & 0xff);
        double b = linear(rgb & 0xff);
        double x = root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
        double y = root(0.2126 * r + 0.7152 * g + 0.0722 * b);
        double z = root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
        return new double[] {116 * y - 16, 500 * (x - y), 200 * (y - z)};
    }

    private static double linear(int value) {
        double encoded = value / 255.0;
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    private static double root(double value) {
        return value > 216.0 / 24389 ? Math.cbrt(value) : (24389.0 / 27 * value + 16) / 116;
    }

    private static void assertSame(BufferedImage picture, String reference, double rarelyExceeded) throws IOException {
        double[] differences = differences(picture, reference);
        assertThat(Arrays.stream(differences).average().orElseThrow())
                .as("mean difference to %s", reference)
                .isLessThan(MEAN);
        assertThat(differences[(int) (0.98 * differences.length)])
                .as("98th percentile of the difference to %s", reference)
                .isLessThan(rarelyExceeded);
    }

    @ParameterizedTest
    @CsvSource({"elaphe, elaphe", "xenopeltis, xenopeltis", "light-above, light-above"})
    void scenesLookAsBeforeAtTheirDefaults(String scene, String reference) throws IOException {
        assertSame(render(scene), reference, RARELY_EXCEEDED);
    }

    @Test
    void aSceneByOneSampleAPixelLooksAsBefore() throws IOException {
        assertSame(render("elaphe", "--supersample", "1"), "elaphe-one-sample", RARELY_EXCEEDED_BY_ONE_SAMPLE);
    }

    @Test
    void aZoomedSceneLooksAsBefore() throws IOException {
        assertSame(render("elaphe-scales", "--supersample", "2"), "elaphe-scales", RARELY_EXCEEDED);
    }

    @Test
    void aSceneUnderThreeLightsLooksAsBefore() throws IOException {
        assertSame(
                render(workplace.resolve("three-lights.json").toString(), "--supersample", "2"),
                "three-lights",
                RARELY_EXCEEDED);
    }

    @Test
    void aSceneByTheThesisSPresetLooksAsBefore() throws IOException {
        assertSame(
                render("xenopeltis", "--method", "full", "--preset", "thesis", "--supersample", "1"),
                "xenopeltis-thesis",
                RARELY_EXCEEDED);
    }
}
