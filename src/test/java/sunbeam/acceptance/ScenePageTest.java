package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Base64;
import java.util.stream.IntStream;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.color.CieLab;

/** A page of a scene holds all that it needs, and shows what {@code render} draws. */
class ScenePageTest extends InOneWorkplace {
    private static final String OBJECT = "\"mesh\": \"sphere\", \"patch\": \"sinusoid\", \"texture\": \"bands.png\"";

    private static String report;
    private static String page;

    private static void scene(String name, String keys) throws IOException {
        Files.writeString(workplace.resolve(name), """
                { "camera": { "position": ["10 cm", "-30 cm", "15 cm"], "lookAt": ["0 cm", "0 cm", "2 cm"], "up": [0, 0, 1], "fieldOfView": "40 deg" },
                  "light": { "direction": [0.5, -0.4, 0.7] }, "roughness": "3 deg",
                  "weights": { "diffraction": 9000, "texture": 0.8, "diffuse": 0.6, "ambient": 0.1 },
                  "ground": "#9a8a74", "sky": 0.4, "shadows": true, %s }
                """.formatted(keys));
    }

    @BeforeAll
    static void export() throws IOException {
        BufferedImage bands = new BufferedImage(4200, 16, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 4200 * 16; i++) {
            bands.setRGB(i % 4200, i / 4200, i % 4200 / 300 % 2 == 0 ? 0x8a3020 : 0x202020);
        }
        ImageIO.write(bands, "png", workplace.resolve("bands.png").toFile());
        scene("ball.json", "\"title\": \"A <ball> with @DATA@\", " + OBJECT);
        report = workplace
                .succeedHere("export ball.json --format html --output ball.html --tolerance 0.1")
                .stdout();
        page = Files.readString(workplace.resolve("ball.html"));
    }

    private static String element(String id) {
        String start = "id=\"" + id + "\">";
        int first = page.indexOf(start) + start.length();
        return page.substring(first, page.indexOf("</script>", first));
    }

    @Test
    void aPageHoldsItsMeshAndTextures() throws IOException {
        JsonNode scene = new ObjectMapper().readTree(element("table")).path("scene");
        byte[] columns = new InflaterInputStream(
                        new ByteArrayInputStream(Base64.getDecoder().decode(element("mesh"))))
                .readAllBytes();
        int vertices = scene.path("mesh").path("vertices").asInt();
        int indices = scene.path("mesh").path("indices").asInt();
        int ground = scene.path("groundSide").asInt();
        int sky = scene.path("skySide").asInt();

        // Position, two directions, texture coordinate and sky are ten integers; a square of the ground is one, of the
        // sky three.
        assertThat(columns).hasSize(4 * (10 * vertices + indices + ground * ground + 3 * sky * sky));
        assertThat(vertices).isGreaterThan(100);
        for (String texture : new String[] {"bodyTexture", "skinRelief", "patchDirections"}) {
            byte[] image = Base64.getDecoder().decode(element(texture).split(",", -1)[1]);
            assertThat(ImageIO.read(new ByteArrayInputStream(image)))
                    .as(texture)
                    .isNotNull();
        }
        assertThat(report).contains("bodyTexture of 4200 x 16 texels is reduced to a longer side of 4096");
        assertThat(page.length()).isLessThan(6_000_000);
        assertThat(page)
                .doesNotContain("http")
                .contains("<title>A &lt;ball&gt; with @DATA@</title>", "<h1>A &lt;ball&gt; with @DATA@</h1>")
                .contains("<p>A repeated patch with a period of 2.5");
        assertThat(page.replace("with @DATA@", "")).doesNotContainPattern("@[A-Z]+@");
    }

    @Test
    void aPageShowsWhatRenderDraws() throws Exception {
        OtherPrograms.requireChromium();
        workplace.succeedHere("render ball.json --size 320x240 --output drawn.png");

        OtherPrograms.chromium(
                workplace.folder(),
                "--window-size=320,240",
                "--screenshot=shown.png",
                workplace.folder().toUri() + "ball.html#bare");

        BufferedImage drawn = ImageIO.read(workplace.resolve("drawn.png").toFile());
        BufferedImage shown = ImageIO.read(workplace.resolve("shown.png").toFile());
        double sum = 0;
        int colored = 0;
        for (int i = 0; i < 320 * 240; i++) {
            CieLab one = CieLab.ofSrgb(drawn.getRGB(i % 320, i / 320));
            sum += one.difference(CieLab.ofSrgb(shown.getRGB(i % 320, i / 320)));
            colored += Math.hypot(one.a(), one.b()) > 30 ? 1 : 0;
        }
        assertThat(colored).as("pixels of a strong color").isGreaterThan(500);
        // One is what an eye just sees.
        assertThat(sum / (320 * 240)).as("mean CIEDE2000").isLessThan(1);
        // Means of the samples' taps have no pattern, those of the squares of 2 x 2 pixels of some drivers have one.
        assertThat(checkerboard(shown)).as("pattern of the shadow").isLessThan(1.5 * checkerboard(drawn));
    }

    /** Returns the mean difference of the two diagonals of squares of 2 x 2 pixels that are nearly gray, as the ground is. */
    private static double checkerboard(BufferedImage image) {
        return IntStream.range(0, (image.getWidth() - 1) * (image.getHeight() - 1))
                .mapToObj(i -> {
                    int x = i % (image.getWidth() - 1);
                    int y = i / (image.getWidth() - 1);
                    return IntStream.of(0, 1, 2, 3)
                            .mapToObj(corner -> CieLab.ofSrgb(image.getRGB(x + corner % 2, y + corner / 2)))
                            .toList();
                })
                .filter(corners -> corners.stream().allMatch(color -> Math.hypot(color.a(), color.b()) < 12))
                .mapToDouble(corners -> Math.abs(corners.get(0).lightness()
                        - corners.get(1).lightness()
                        - corners.get(2).lightness()
                        + corners.get(3).lightness()))
                .average()
                .orElseThrow();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "4|two.json --format html --output x.html|scene two.json has no page: objects: 2 of them, and a page holds one",
                "2|ball.json --format npz --output x.npz|ball.json' is a scene, which --format html shows",
                "2|ball.json --format html --size 50KB --output x.html|give a simpler mesh or smaller textures, or a larger --size",
                "2|blaze --scene disc --format html --output x.html|both name what is shown"
            })
    void whatHasNoPageIsRefusedInOneLine(int code, String command, String reason) throws IOException {
        scene("two.json", "\"objects\": [{ %s }, { %s }]".formatted(OBJECT, OBJECT));

        workplace.here("export " + command).complains(code, reason);

        assertThat(workplace.resolve("x.html")).doesNotExist();
    }
}
