package sunbeam.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.scene.SceneSettings.ANGULAR_DIAMETER;
import static sunbeam.app.scene.SceneSettings.ROTATE_PATCH;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import jrtr.gl.RenderContext;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.files.input.PngText;
import sunbeam.app.gpu.BrdfMapRenderer.DiscDirections;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.colors.DiffractionSetup;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.terminal.ExitCode;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.setting.Choices;

/** Exposure, annotation and light of maps. */
@NeedsDisplay
class BrdfMapCommandTest extends CommandLineFixture {
    private int draw(String file, String options) {
        return sunbeam(map(file, options));
    }

    private static String map(String file, String options) {
        return "brdf-map --size 24 --output @" + file + " " + options;
    }

    private double exposure(String file, String options) {
        assertSuccess(draw(file, options));
        return Double.parseDouble(PngText.read(folder.resolve(file)).get("Exposure"));
    }

    private BufferedImage image(String file) throws IOException {
        return ImageIO.read(folder.resolve(file).toFile());
    }

    /** A longer window must not turn the blazed grating's few orders, or a skin's spread light, from gray to black. */
    @ParameterizedTest
    @ValueSource(strings = {"blaze", "elaphe-like"})
    void automaticExposureFollowsTheWindowGradually(String patch) {
        double first = exposure("a.png", "--patch " + patch + " --coherence-length 6um");
        double second = exposure("b.png", "--patch " + patch + " --coherence-length 6.3um");

        // A window 5 % longer makes an order's area a tenth smaller and its rho a tenth larger.
        assertThat(second / first).isBetween(0.8, 1.25);
    }

    @Test
    void severalMapsShareOneExposure() throws IOException {
        double both = exposure("all.png", "--patch blaze --with lamellar --annotate");
        double blaze = exposure("blaze.png", "--patch blaze --annotate");
        double lamellar = exposure("lamellar.png", "--patch lamellar --no-annotate");
        double first = exposure("first.png", "--patch blaze --with lamellar --exposure first");

        // The brighter half of all pixels consists of pixels of both maps, so its exposure lies near theirs.
        assertThat(both).isBetween(0.5 * Math.min(blaze, lamellar), Math.max(blaze, lamellar));
        assertThat(first).isEqualTo(blaze);
        assertThat(PngText.read(folder.resolve("all.png"))).containsEntry("Title", "BRDF map of blaze, lamellar");
        assertThat(image("all.png").getWidth())
                .isGreaterThanOrEqualTo(2 * image("blaze.png").getWidth());
        assertThat(image("lamellar.png").getWidth()).as("not annotated").isEqualTo(24);
    }

    @Test
    void resumeLeavesAMapThatWasMadeAlike() throws IOException {
        String flat = grating("flat", 0).toString();
        assertThat(draw("a.png", "--patch " + flat + " --resume")).isEqualTo(ExitCode.TOLERANCE_MISSED.code());
        FileTime made = FileTime.fromMillis(1_000_000);
        Files.setLastModifiedTime(folder.resolve("a.png"), made);

        assertThat(draw("a.png", "--patch " + flat + " --resume"))
                .as("the same verdict")
                .isEqualTo(ExitCode.TOLERANCE_MISSED.code());
        assertThat(draw("a.png", "--patch blaze --resume")).isEqualTo(ExitCode.OUTPUT_EXISTS.code());
        assertThat(Files.getLastModifiedTime(folder.resolve("a.png"))).isEqualTo(made);
    }

    @Test
    void aMapsBytesDoNotDependOnTheNamesOfItsFiles() throws IOException {
        draw("a.png", "--patch blaze --linear @a.npy");
        draw("b.png", "--patch blaze --linear @b.npy");

        assertThat(folder.resolve("b.png")).hasSameBinaryContentAs(folder.resolve("a.png"));
    }

    @Test
    void resumeDrawsAgainWhereTheLinearFileIsAnotherOne() throws IOException {
        Path linear = folder.resolve("a.npy");
        String command = "--patch blaze --linear " + linear + " --resume";
        draw("a.png", command);
        byte[] colors = Files.readAllBytes(linear);
        FileTime made = FileTime.fromMillis(1_000_000);
        Files.setLastModifiedTime(folder.resolve("a.png"), made);

        draw("a.png", command);
        assertThat(Files.getLastModifiedTime(folder.resolve("a.png"))).isEqualTo(made);
        Files.writeString(linear, "something else");
        String forced = "--patch blaze --linear " + linear + " --resume --force";
        assertThat(draw("a.png", forced)).isEqualTo(ExitCode.OK.code());
        assertThat(linear).hasBinaryContent(colors);
    }

    /** Waves of 1 um across 20 um. */
    private Path grating(String name, double nanometers) throws IOException {
        String header = "# Channel: Height\n# Width: 20 um\n# Height: 20 um\n# Value units: nm\n";
        return scan(name + ".txt", header, 200, 200, (column, row) -> nanometers * Math.sin(2 * Math.PI * column / 10));
    }

    @Test
    void anotherPicturesExposureIsTaken() {
        double blaze = exposure("blaze.png", "--patch blaze");

        assertThat(exposure("other.png", "--patch lamellar --exposure @blaze.png"))
                .isEqualTo(blaze);
    }

    @Test
    void whatHoldsNoExposureIsRefused() throws IOException {
        Path none = Files.writeString(folder.resolve("none.png"), "no picture");
        String map = map("a.png", "--exposure @none.png");
        assertComplaint(ExitCode.UNUSABLE_INPUT, map, "none.png: it is no PNG file");
        ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", none.toFile());
        assertComplaint(ExitCode.UNUSABLE_INPUT, map, "none.png: it has no text 'Exposure'");
        assertComplaint(ExitCode.USAGE, map("a.png", "--exposure firs"), "--exposure");
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    /** Returns the linear colors of a map, three per pixel. */
    private float[] linear(String more) throws IOException {
        assertSuccess(draw(
                "map.png", "--patch sinusoid --theta-i 60 --coherence-length 4um --force --linear @map.npy" + more));
        return floats("map.npy", 3 * 24 * 24);
    }

    /** At every pixel the map changes by the ratio of Schlick's reflectances, also for an index by wavelength. */
    @Test
    void anotherIndexReflectsMoreOrLessAsSchlickSays() throws IOException {
        Path constant = Files.writeString(folder.resolve("two.csv"), "wl,n\n0.3,2\n0.5,2\n0.9,2\n");
        float[] standard = linear("");
        float[] two = linear(" --index 2");
        float[] tabulated = linear(" --index " + constant);
        DiscDirections directions = new DiscDirections(24, Direction.ofDegrees(60, 0));
        RefractiveIndex index = RefractiveIndex.constant(2, 0);
        int[] lit = IntStream.range(0, 24 * 24)
                .filter(pixel -> standard[3 * pixel + 1] > 1e-6)
                .toArray();
        assertThat(lit).hasSizeGreaterThan(50);
        for (int pixel : lit) {
            double cosine = directions.at(pixel).cosThetaD();
            double relative = index.reflectance(5e-7, cosine) / index.reflectance(5e-7);
            double found = two[3 * pixel + 1] / standard[3 * pixel + 1];
            // Both maps are rounded to float32.
            assertThat(found)
                    .as("pixel %s", pixel)
                    .isCloseTo(relative / (Gain.reflectance(cosine) / Gain.R0), within(1e-6));
            // Both integrals have a tolerance of 1e-3.
            assertThat(tabulated[3 * pixel + 1] / two[3 * pixel + 1]).isCloseTo(1f, within(3e-3f));
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            --index @gold.csv --certify 2 | --certify holds one integral against the reference, but an --index by wavelength
            --with blaze --linear @x.npy  | --linear is for one map
            --with blaze --certify 2      | --certify is for one map
            """)
    void whatAMapDoesNotHaveIsRefused(String options, String words) throws IOException {
        Files.writeString(folder.resolve("gold.csv"), "wl,n,k\n0.3,1.5,1.9\n0.9,0.2,5.4\n");
        assertComplaint(ExitCode.USAGE, map("a.png", options), words);
        assertThat(folder.resolve("a.png")).doesNotExist();
    }

    private static final int SIZE = 24;
    private static final double THETA = 50;
    private static final double PHI = 20;

    @Test
    void aLampsMapIsTheMeanOverItsDirections() {
        Choices choices = Choices.none()
                .with(AVERAGE, Average.ENSEMBLE)
                .with(COHERENCE_LENGTH, 8e-6)
                .with(ROTATE_PATCH, 0.3);
        double diameter = Math.toRadians(6);
        // Five directions along each axis, 1.2 deviations of the light apart: as the window's orders are wider than
        // that, a sum over them errs by 1e-3; 2 % of the light lie beyond.
        double all = Math.pow(1 + 2 * Math.exp(-0.72) + 2 * Math.exp(-2.88), 2);
        double[] mean = new double[3 * SIZE * SIZE];
        try (RenderContext context = RenderContext.offscreen()) {
            for (int i = 0; i < 25; i++) {
                double along = 1.2 * (i % 5 - 2);
                double across = 1.2 * (i / 5 - 2);
                double weight = Math.exp(-0.5 * (along * along + across * across)) / all;
                float[] xyz = draw(context, choices, aside(along * diameter / 4, across * diameter / 4));
                Arrays.setAll(mean, c -> mean[c] + weight * xyz[c]);
            }
            // The window has the lamp's width at 550 nm; at 450 nm its variance is a third too small.
            float[] lamp = draw(context, choices.with(ANGULAR_DIAMETER, diameter), aside(0, 0));
            assertThat(error(lamp, mean)).isLessThan(0.1);
            float[] point = draw(context, choices, aside(0, 0));
            assertThat(error(point, mean)).as("a point of light").isGreaterThan(0.2);
        }
    }

    /** Of a rough surface. The lamp widens its orders by a twentieth, by which a point's map is too sharp. */
    @Test
    void aMapOfAPointMissesTheCertificateOfALamp() throws IOException {
        DiffractionSetup setup = new MethodProbe(folder, rough(64)).setup();
        Choices choices = Choices.none().with(AVERAGE, Average.ENSEMBLE).with(COHERENCE_LENGTH, 4e-6);
        MaterialMap point = new MaterialMap(setup, choices, RefractiveIndex.KERATIN, aside(0, 0));
        MaterialMap lamp = new MaterialMap(
                setup, choices.with(ANGULAR_DIAMETER, Math.toRadians(5)), RefractiveIndex.KERATIN, aside(0, 0));
        try (RenderContext context = RenderContext.offscreen()) {
            LinearPicture drawn = lamp.draw(context, SIZE).picture();
            double exposure = LinearPicture.exposure(drawn);
            Certificate kept = lamp.certify(drawn, 8, exposure);
            Certificate missed = lamp.certify(point.draw(context, SIZE).picture(), 8, exposure);
            assertThat(kept.missed()).as(kept.summary()).isFalse();
            assertThat(missed.missed()).as(missed.summary()).isTrue();
        }
    }

    private static double error(float[] map, double[] mean) {
        double brightest = Arrays.stream(mean).filter(Double::isFinite).max().orElseThrow();
        IntStream lit = IntStream.range(0, mean.length).filter(c -> mean[c] > 0.01 * brightest);
        return Quantiles.of(lit.mapToDouble(c -> Math.abs(map[c] / mean[c] - 1)).toArray(), 0.5);
    }

    private float[] draw(RenderContext context, Choices choices, Direction light) {
        return new MaterialMap(new MethodProbe(folder, "blaze").setup(), choices, RefractiveIndex.KERATIN, light)
                .draw(context, SIZE)
                .picture()
                .xyz();
    }

    /** Returns the direction at these distances, in radians, from the lamp's middle along its meridian and across. */
    private static Direction aside(double along, double across) {
        Direction middle = Direction.ofDegrees(THETA, PHI);
        Direction down = Direction.ofDegrees(THETA + 90, PHI);
        Vector3d place = new Vector3d(middle.x(), middle.y(), middle.z())
                .fma(along, new Vector3d(down.x(), down.y(), down.z()))
                .fma(across, new Vector3d(-Math.sin(Math.toRadians(PHI)), Math.cos(Math.toRadians(PHI)), 0))
                .normalize();
        return new Direction(place.x, place.y, place.z);
    }
}
