package sunbeam.app.cli.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.cli.CommandLineFixture;
import sunbeam.app.cli.render.AnimationOptions.GifAnimation;
import sunbeam.app.cli.render.AnimationOptions.Sweep;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.terminal.ExitCode;

@NeedsDisplay
class RenderCommandTest extends CommandLineFixture {
    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("scene.json"), SCENE);
    }

    private int render(String output, String options) {
        return sunbeam("render @scene.json --size 40x30 --output @" + output + options);
    }

    @Test
    void aPictureSaysHowItWasMadeAndIsNotOverwritten() {
        Path picture = folder.resolve("a.png");
        assertSuccess(render("a.png", " --linear @a.npy --supersample 2"));
        Map<String, String> text = PngText.read(picture);
        assertThat(text).containsKeys("Scene", "Plan", "Exposure", "Parameters");
        assertThat(text.get("Scene")).contains("\"blaze\"");
        assertThat(folder.resolve("a.npy")).content(StandardCharsets.ISO_8859_1).contains("'shape': (30, 40, 3)");
        assertThat(render("a.png", "")).isEqualTo(ExitCode.OUTPUT_EXISTS.code());
        assertThat(render("a.png", " --force")).isZero();
    }

    @Test
    void aCertificateComparesAPictureWithPointsOfIt() throws IOException {
        Files.writeString(scene, SCENE.replaceFirst("\"method\": \"full\", ", ""));
        assertSuccess(render("a.png", " --certify 6"));
        assertThat(PngText.read(folder.resolve("a.png")).get("Plan"))
                .as("a scene that names no method")
                .startsWith("table:");
    }

    @Test
    void resumeDrawsWhatIsMissingOnly() throws IOException {
        Path frames = folder.resolve("turn");
        assertSuccess(render("turn", " --turntable 3"));
        Path first = frames.resolve("frame-0001.png");
        Path second = frames.resolve("frame-0002.png");
        byte[] drawn = Files.readAllBytes(second);
        Files.delete(second);
        FileTime old = FileTime.fromMillis(1_000_000);
        Files.setLastModifiedTime(first, old);

        assertThat(render("turn", " --turntable 3")).as("without --resume").isEqualTo(ExitCode.OUTPUT_EXISTS.code());
        assertSuccess(render("turn", " --turntable 3 --resume"));
        assertThat(Files.getLastModifiedTime(first)).isEqualTo(old);
        assertThat(Files.readAllBytes(second)).isEqualTo(drawn);

        assertThat(render("turn", " --turntable 3 --resume --texture-weight 0.3"))
                .isEqualTo(ExitCode.OUTPUT_EXISTS.code());
        assertThat(err.toString()).contains("frame-0001.png", "other parameters", "--force");
        assertThat(render("turn", " --turntable 1 --resume")).isEqualTo(ExitCode.OUTPUT_EXISTS.code());
        assertThat(err.toString()).contains("cannot end before", "frame-0002.png: it exists; add --force");
        assertSuccess(render("turn", " --turntable 1 --resume --force"));
        assertThat(frames.toFile().list()).containsExactlyInAnyOrder("frame-0001.png", "animation.gif");
    }

    @Test
    void sweepsHaveBothEndsAndWholeTurnsLeaveTheLastOut() {
        Sweep half = new Sweep(0, Math.PI);
        assertThat(half.at(4, 5)).isEqualTo(Math.PI);
        assertThat(new Sweep(0, 2 * Math.PI).at(3, 4)).isCloseTo(1.5 * Math.PI, within(1e-12));
        assertThat(half.at(0, 1)).isZero();
    }

    @Test
    void theThesissPresetChoosesItsMethod() {
        assertSuccess(sunbeam("render elaphe --size 40x30 --output @t.png --mesh plane --patch blaze --preset thesis"));
        assertThat(PngText.read(folder.resolve("t.png"))).containsEntry("Method", "full");
    }

    @Test
    void aSweepIsAlsoAnAnimation() throws IOException {
        Path frames = folder.resolve("sweep");
        assertSuccess(render("sweep", " --light-sweep -30:30 --frames 3"));
        try (ImageInputStream stream =
                ImageIO.createImageInputStream(frames.resolve("animation.gif").toFile())) {
            ImageReader reader = ImageIO.getImageReaders(stream).next();
            reader.setInput(stream);
            assertThat(reader.getNumImages(true)).isEqualTo(3);
            assertThat(reader.getWidth(0)).isEqualTo(40);
            for (int frame = 0; frame < 3; frame++) {
                BufferedImage drawn = ImageIO.read(
                        frames.resolve("frame-000" + (frame + 1) + ".png").toFile());
                // A palette of 256 colors has steps of about 8 codes in each channel.
                assertThat(meanDifference(reader.read(frame), drawn))
                        .as("difference per channel of frame %d", frame)
                        .isLessThan(8);
            }
        }
        assertThat(Files.readAllBytes(frames.resolve("frame-0001.png")))
                .isNotEqualTo(Files.readAllBytes(frames.resolve("frame-0003.png")));
    }

    /** APNG keeps all colors. Without the program the option names it. */
    @Test
    void aFilmHasTheFramesOrTheProgramIsNamed() throws Exception {
        int code = render("film100%", " --light-sweep -30:30 --frames 2 --film apng");
        if (code != ExitCode.OK.code()) {
            assertThat(code).isEqualTo(ExitCode.USAGE.code());
            assertThat(err.toString()).contains("--film apng needs the program ffmpeg", "or leave --film out");
            assertThat(folder.resolve("film100%")).doesNotExist();
            return;
        }
        Path frames = folder.resolve("film100%");
        Process reading = new ProcessBuilder(
                        "ffmpeg", "-nostdin", "-i", "animation.apng", "-fps_mode", "passthrough", "read-%d.png")
                .directory(frames.toFile())
                .redirectErrorStream(true)
                .start();
        reading.getInputStream().readAllBytes();
        assertThat(reading.waitFor()).isZero();
        for (int frame = 1; frame <= 2; frame++) {
            BufferedImage read =
                    ImageIO.read(frames.resolve("read-" + frame + ".png").toFile());
            BufferedImage drawn =
                    ImageIO.read(frames.resolve("frame-000" + frame + ".png").toFile());
            assertThat(meanDifference(read, drawn)).as("frame %d", frame).isZero();
        }
        assertThat(frames.resolve("read-3.png")).doesNotExist();
    }

    private static double meanDifference(BufferedImage one, BufferedImage other) {
        int[] a = one.getRGB(0, 0, one.getWidth(), one.getHeight(), null, 0, one.getWidth());
        int[] b = other.getRGB(0, 0, other.getWidth(), other.getHeight(), null, 0, other.getWidth());
        return IntStream.range(0, 3 * a.length)
                .map(i -> ((a[i / 3] >> (8 * (i % 3))) & 0xff) - ((b[i / 3] >> (8 * (i % 3))) & 0xff))
                .map(Math::abs)
                .average()
                .orElseThrow();
    }

    @Test
    void aPictureDoesNotReplaceAnImageOfItsScene() throws IOException {
        Path texture = Files.write(folder.resolve("skin.png"), new byte[] {1});
        Files.writeString(scene, SCENE.replace("\"none\"", "\"skin.png\""));
        assertComplaint(
                ExitCode.USAGE,
                "render @scene.json --output @skin.png --force",
                "is a file of the scene; give another name");
        assertThat(texture).hasBinaryContent(new byte[] {1});
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --light-sweep 0 | is not a sweep
            --supersample 0 | --supersample 0 is out of range
            --turntable 2 --light-sweep 0:1 | contradict each other
            --exposure -1 | --exposure
            --method pq | has no ensemble average, which the scene asks for; add --average coherent
            --method gem --patch elaphe-like | for example 1um
            --method table --preset thesis | --preset thesis belongs to --method full, nmm, pq, gem or reference, not table; leave it out or use --method full
            --size 0x5 | --size
            --scales keeled | --scales keeled is for mesh snake; leave it out
            --frames 5 | --frames 5 needs --light-sweep, whose frames it counts, as in
            --frames 5 --turntable 3 | --turntable has its own number
            --frame-rate 5 | --frame-rate needs --light-sweep or --turntable
            --certify 0 | --certify 0 is out of range
            --certify 6 --method nmm --average coherent | method nmm
            """)
    void aMistakeIsAUsageErrorThatNamesIt(String options, String words) throws IOException {
        Files.writeString(scene, SCENE.replace("\"method\": \"full\", ", ""));
        assertComplaint(ExitCode.USAGE, "render @scene.json --size 40x30 --output @b.png " + options, words);
        assertThat(folder.resolve("b.png")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            elaphe --coherence-length 10mm | DRIVER_LIMIT   | a shorter --coherence-length, or --method full
            elafe                          | UNUSABLE_INPUT | elafe
            """)
    void whatCannotBeDrawnIsToldInALine(String scene, ExitCode code, String words) {
        assertComplaint(code, "render " + scene + " --output @b.png", words);
    }

    /** A grating on a smooth sphere sends only specks of light into the camera, and a small picture may have none. */
    @Test
    void aPictureOfSpecksIsDoubtful() throws IOException {
        Files.writeString(folder.resolve("specks.json"), exampleOfTheDocs());

        assertThat(sunbeam("render @specks.json --size 24x18 --output @specks.png --patch sinusoid --method full"
                        + " --roughness 0deg --texture-weight 0"))
                .as(err.toString())
                .isEqualTo(ExitCode.TOLERANCE_MISSED.code());
        assertThat(err.toString())
                .containsPattern("lit: .* % of \\d+ pixels")
                .contains("of the mesh is lit", "move the light");
    }

    @Test
    void theExampleOfTheDocsShowsColors() throws IOException {
        Files.writeString(folder.resolve("example.json"), exampleOfTheDocs());

        assertSuccess(sunbeam("render @example.json --size 64x48 --output @example.png"));
        BufferedImage image = ImageIO.read(folder.resolve("example.png").toFile());
        long colored = IntStream.of(image.getRGB(0, 0, 64, 48, null, 0, 64))
                .mapToObj(rgb -> Color.RGBtoHSB(rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff, null))
                .filter(hsb -> hsb[1] > 0.3f && hsb[2] > 0.2f)
                .count();
        // The two arcs beside the highlight are colored; the highlight is white.
        assertThat(colored).isGreaterThan(50);
    }

    private static String exampleOfTheDocs() throws IOException {
        String page = Files.readString(Path.of("../docs/scenes.md"));
        return page.substring(page.indexOf("    {\n"), page.indexOf("    }\n") + 6);
    }

    private static final int SIDE = 256;
    private static final int BLOCK = 16;

    @Test
    void smoothColorsHaveNoBands() throws IOException {
        BufferedImage smooth = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            smooth.setRGB(x, y, x << 16 | y << 8 | (255 - x) / 2);
        }
        Path frame = folder.resolve("frame.png");
        ImageIO.write(smooth, "png", frame.toFile());
        GifAnimation.write(folder.resolve("a.gif"), Overwrite.REPLACE, List.of(frame), 10);

        BufferedImage drawn = ImageIO.read(folder.resolve("a.gif").toFile());
        double[] sums = new double[SIDE / BLOCK * (SIDE / BLOCK)];
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            int error = (drawn.getRGB(x, y) >> 8 & 255) - (smooth.getRGB(x, y) >> 8 & 255);
            sums[x / BLOCK + y / BLOCK * (SIDE / BLOCK)] += error;
        }
        double worst = Arrays.stream(sums).map(Math::abs).max().orElseThrow() / (BLOCK * BLOCK);
        // The palette has steps of 32 codes, so without dither the blocks' means err by 9. At the edges dither loses
        // errors.
        assertThat(worst).isLessThan(4);
    }
}
