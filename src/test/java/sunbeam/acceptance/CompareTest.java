package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Random;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Runs {@code compare} on photographs made of a scene's light with known exposure and noise. */
class CompareTest extends InOneWorkplace {
    private static final String SCENE = """
            {
              "mesh": "sphere",
              "patch": "blaze",
              "camera": { "position": ["0 m", "-20 cm", "45 cm"], "lookAt": ["0 m", "0 m", "0 m"] },
              "light": { "direction": [-0.2, 0.3, 0.9] },
              "texture": "none",
              "roughness": "0 deg",
              "plan": { "method": "full", "tolerance": 0.05 },
              "weights": { "diffraction": 30, "texture": 0.6, "ambient": 0.3 }
            }
            """;
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final double EXPOSURE = 0.37;
    private static final double NOISE = 0.004;
    /** IEC 61966-2-1, XYZ to linear sRGB, and the luminance of its channels. */
    private static final double[][] FROM_XYZ = {
        {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}
    };

    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};

    private static NpyImage light;

    @BeforeAll
    static void draw() throws IOException {
        Files.writeString(workplace.resolve("scene.json"), SCENE);
        workplace.succeedHere("render scene.json --size 64x48 --linear scene.npy --output scene.png");
        light = NpyImage.read(workplace.resolve("scene.npy"), WIDTH);
    }

    /** Returns a photograph's sample for a channel of a pixel. */
    private interface Sensor {
        double light(int row, int column, int channel);
    }

    /** Returns the scene's light; a gray wall beside the mesh. */
    private static double scene(int row, int column, int channel) {
        if (Float.isNaN(light.at(row, column, 1))) {
            return 0.2;
        }
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += FROM_XYZ[channel][c] * light.at(row, column, c);
        }
        return EXPOSURE * sum;
    }

    /** Writes a picture of 16 bits; its left quarter is transparent and has another color. */
    private static void photograph(String name, Sensor sensor) throws IOException {
        ColorSpace srgb = ColorSpace.getInstance(ColorSpace.CS_sRGB);
        BufferedImage image = ImageTypeSpecifier.createInterleaved(
                        srgb, new int[] {0, 1, 2, 3}, DataBuffer.TYPE_USHORT, true, false)
                .createBufferedImage(WIDTH, HEIGHT);
        WritableRaster raster = image.getRaster();
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                boolean masked = column < WIDTH / 4;
                for (int c = 0; c < 3; c++) {
                    double linear = Math.min(1, Math.max(0, masked ? 0.9 : sensor.light(row, column, c)));
                    double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
                    raster.setSample(column, row, c, (int) Math.round(65_535 * encoded));
                }
                raster.setSample(column, row, 3, masked ? 0 : 65_535);
            }
        }
        ImageIO.write(image, "png", workplace.resolve(name).toFile());
    }

    private static String command(String photo, String more) {
        return "compare " + photo + " scene.json --json --output " + photo + "-compared.png" + more;
    }

    /** The only errors are rounding to 16 bits (1e-5 of light) and the matrix's four digits (1e-4). */
    @Test
    void theScenesOwnLightIsFoundAgain() throws IOException {
        photograph("clean.png", CompareTest::scene);
        JsonNode report = workplace.json(command("clean.png", ""));
        assertThat(report.get("exposure").asDouble()).isCloseTo(EXPOSURE, within(2e-4 * EXPOSURE));
        assertThat(report.get("ciede2000_median").asDouble()).isLessThan(0.05);
        assertThat(report.get("luminance_correlation").asDouble()).isGreaterThan(0.9999);
        assertThat(report.get("covered_pixels").asInt()).isBetween(200, WIDTH * HEIGHT * 3 / 4);
    }

    /**
     * Noise of each channel gives luminance a deviation s, and least squares the exposure one of s over the root of the
     * scene's squares. Huber's weights add 3 %; four deviations are never exceeded.
     */
    @Test
    void noiseMovesTheExposureByItsOwnErrorAlone() throws IOException {
        Random random = new Random(1);
        photograph("noisy.png", (row, column, c) -> scene(row, column, c) + NOISE * random.nextGaussian());
        JsonNode report = workplace.json(command("noisy.png", ""));
        double squares = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = WIDTH / 4; column < WIDTH; column++) {
                float y = light.at(row, column, 1);
                squares += Float.isNaN(y) ? 0 : y * y;
            }
        }
        double deviation = NOISE * Math.hypot(Math.hypot(LUMINANCE[0], LUMINANCE[1]), LUMINANCE[2]);
        assertThat(report.get("exposure").asDouble())
                .isCloseTo(EXPOSURE, within(4 * 1.03 * deviation / Math.sqrt(squares)));
        // At 0.3 of white, noise of 0.004 changes lightness by about 0.4, and chroma likewise.
        assertThat(report.get("ciede2000_median").asDouble()).isBetween(0.3, 3.0);
    }

    /**
     * A tenth of the pixels are much too bright. The others agree exactly, so the limit of Huber's weights and the influence of the bright
     * ones vanish.
     */
    @Test
    void glintsThatTheSceneLacksDoNotDecideTheExposure() throws IOException {
        photograph("glints.png", (row, column, c) -> (7 * row + 3 * column) % 10 == 0 ? 0.95 : scene(row, column, c));
        assertThat(workplace.json(command("glints.png", "")).get("exposure").asDouble())
                .isCloseTo(EXPOSURE, within(0.02 * EXPOSURE));
    }

    /**
     * Mitsuba's path tracer drew the picture (see resources/mitsuba_sphere.py) with colors exported at a tolerance of 0.01; the noise of
     * 4096 paths per pixel is lower. Its exposure is the scene's, so the fitted factor is 1.
     */
    @Test
    void aSphereDrawnByAnotherProgramIsTheScenes() throws IOException {
        Files.writeString(workplace.resolve("sphere.json"), """
                { "mesh": "sphere", "patch": "elaphe-like", "texture": "none",
                  "camera": { "position": ["0 cm", "-80 cm", "56 cm"], "lookAt": ["0 cm", "0 cm", "0 cm"], "fieldOfView": "13 deg" },
                  "light": { "direction": [0.3, -0.5, 0.8] },
                  "plan": { "method": "table", "coherenceLength": "8 um" },
                  "weights": { "diffraction": %s, "texture": 0 } }
                """.formatted(17 * Math.pow(65 / 8.0, 2)));
        JsonNode report = workplace.json(
                "compare %s sphere.json --json --output sphere.png",
                Sunbeam.repository().resolve("src/test/resources/mitsuba-sphere.png"));
        // Both tables have a tolerance of 0.01; Sunbeam takes four samples per pixel.
        assertThat(report.get("exposure").asDouble()).isCloseTo(1, within(0.02));
        // An error of 0.01 of light is at most 0.5 of lightness; most of the sphere is dark.
        assertThat(report.get("ciede2000_percentile_95").asDouble()).isBetween(0.001, 0.5);
        assertThat(report.get("luminance_correlation").asDouble()).isGreaterThan(0.999);
        assertThat(report.get("hue_correlation").asDouble()).isGreaterThan(0.99);
    }

    /** A fine grating on a smooth sphere lights few pixels; agreement of black pixels proves nothing. */
    @Test
    void blackPicturesThatAgreeAreNoResult() throws IOException {
        String grating = SCENE.replace("blaze", "sinusoid")
                .replace("\"diffraction\": 30, \"texture\": 0.6, \"ambient\": 0.3", "\"texture\": 0, \"ambient\": 0");
        Files.writeString(workplace.resolve("specks.json"), grating);
        workplace.here("render specks.json --size 160x120 --tone clip --output specks.png");

        SunbeamResult result = workplace
                .here("compare specks.png specks.json --output specks-compared.png")
                .ended(3);
        assertThat(result.stdout()).containsPattern("lit: [0-4](\\.\\d+)? % of \\d+ pixels");
        assertThat(result.stderr()).contains("% of the mesh is lit");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            plain.png | --size 40x40 | 2 | has another ratio of sides than the photograph, 64x48; give 40x30
            plain.png | --size 80x60 | 2 | --size 80x60 is larger than the photograph, 64x48
            none.png  | --quiet      | 4 | cannot read none.png: there is no such file; check the name
            white.png | --quiet      | 4 | clipped wherever the mesh is
            """)
    void whatCannotBeComparedIsOneLine(String photo, String option, int code, String words) throws IOException {
        photograph("plain.png", CompareTest::scene);
        photograph("white.png", (row, column, c) -> 1);
        workplace.here(command(photo, " " + option)).complains(code, words);
        assertThat(workplace.resolve(photo + "-compared.png")).doesNotExist();
    }

    @Test
    void aSmallerSizeReducesThePhotograph() throws IOException {
        photograph("reduced.png", CompareTest::scene);
        JsonNode report = workplace.json(command("reduced.png", " --size 32x24"));
        assertThat(report.get("photograph").asText()).isEqualTo("reduced.png, 64x48 reduced to 32x24");
        BufferedImage pair =
                ImageIO.read(workplace.resolve("reduced.png-compared.png").toFile());
        assertThat(pair.getWidth()).isGreaterThan(1000);
    }
}
