package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.PRESET;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.scene.Light;
import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.environment.RadianceFiles;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/** Light from all directions: it returns from surfaces that lose none, and is the sum of its directions. */
class EnvironmentTest extends InAScene {
    private static final int SIZE = 32;
    private static final double WHITE = 127.5 / 128;

    private static Scene table(Choices weights) {
        return blaze().withMethod(new SceneMethod(Choices.none().with(METHOD, TableMethod.TYPE)))
                .with(weights);
    }

    private static Scene under(Scene scene, Object environment, int lights) {
        return scene.with(SceneSettings.ENVIRONMENT, environment.toString())
                .with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(lights));
    }

    private Path white() throws IOException {
        return RadianceFiles.gray(folder.resolve("white.hdr"), 256, 128, (x, y) -> 127);
    }

    private static double[] luminances(float[] rgba) {
        return IntStream.range(0, rgba.length / 4)
                .filter(i -> rgba[4 * i + 3] == 1)
                .mapToDouble(i -> rgba[4 * i + 1])
                .toArray();
    }

    /** What gloss mirrors does not reach the body: both together return all light, from all sides of a sphere but its lower one. */
    @Test
    void aWhiteBodyReturnsAWhiteEnvironment() throws IOException {
        Scene scene = under(table(Weights.of(0, 1, 1, 0.3)), white(), 1024);
        double[] luminances = luminances(drawn(scene, SIZE, SIZE));
        assertThat(luminances).hasSizeGreaterThan(SIZE * SIZE / 5);
        for (double luminance : luminances) {
            // Half of 1024 lights are above the surface; those that straddle the horizon count with their middle.
            assertThat(luminance).isCloseTo(WHITE, within(0.01 * WHITE));
        }
    }

    /**
     * A mirror's light has the solid angle lambda^2 / (4 pi sigma^2), and a white surface's pi. Scalar theory keeps a mirror's energy at
     * these angles. Samples are so close that no replica of the mirror's order is visible.
     */
    @Test
    void aMirrorReturnsAWhiteEnvironment() throws IOException {
        int[] flat = new int[64 * 64];
        Arrays.fill(flat, 0xff808080);
        Choices patch = Choices.none()
                .with(PatchSettings.PATCH, image(BufferedImage.TYPE_BYTE_GRAY, 64, flat))
                .with(PatchSettings.WIDTH, 8e-6)
                .with(PatchSettings.MAX_HEIGHT, 1e-9);
        double sigma = CoherenceWindow.ofCoherenceLength(65e-6).sigmaMeters();
        CieTable cie = CieTable.load();
        double squares = IntStream.rangeClosed(380, 780)
                .mapToDouble(nm -> Math.pow(nm * 1e-9, 2) * cie.at(nm * 1e-9, 1))
                .sum();
        double sum = IntStream.rangeClosed(380, 780)
                .mapToDouble(nm -> cie.at(nm * 1e-9, 1))
                .sum();
        double weight = 4 * Math.pow(Math.PI * sigma, 2) * sum / squares;
        Scene mirror = table(Weights.of(weight, 0, 0, 0)).withPatch(new PatchRequest(patch));
        double[] sorted = Arrays.stream(luminances(drawn(under(mirror, white(), 2048), 24, 24)))
                .sorted()
                .toArray();
        double mean = Arrays.stream(sorted).average().orElseThrow();
        assertThat(mean).isCloseTo(WHITE, within(0.01 * WHITE));
        // A perfect mirror shows the lights' lattice, which is not quite regular.
        assertThat(sorted[sorted.length / 20]).isGreaterThan(0.85 * WHITE);
        assertThat(sorted[sorted.length * 19 / 20]).isLessThan(1.15 * WHITE);
    }

    @Test
    void aBrightPixelIsTheLightOfItsDirection() throws IOException {
        Path file = RadianceFiles.gray(folder.resolve("pixel.hdr"), 128, 64, (x, y) -> x == 60 && y == 12 ? 200 : 0);
        Light light = RadianceMap.load(file.toString())
                .lights()
                .groups(1, 1)
                .get(0)
                .lights()
                .get(0);
        Scene scene = table(DIFFRACTION_ONLY);
        Scene alone = scene.withLight(
                new SceneLight(light.towards(), light.radiance().y(), 4 * LightList.OVERLAP * light.deviation()));
        float[] expected = drawn(alone, SIZE, SIZE);
        float[] environment = drawn(under(scene, file, 64), SIZE, SIZE);
        double brightest = Arrays.stream(luminances(expected)).max().orElseThrow();
        assertThat(brightest).isGreaterThan(0);
        for (int i = 0; i < expected.length; i++) {
            // float32 of colors that go to Rec. 709 and back.
            assertThat((double) environment[i]).isCloseTo(expected[i], within(1e-5 * brightest + 1e-5 * expected[i]));
        }
    }

    @Test
    void theBrightestLightIsThatOfTheBrightPixelAndTurnsWithTheEnvironment() throws IOException {
        Path pixel = RadianceFiles.gray(folder.resolve("pixel.hdr"), 128, 64, (x, y) -> x == 60 && y == 12 ? 200 : 0);
        Path sun = RadianceFiles.gray(folder.resolve("sun.hdr"), 128, 64, (x, y) -> x == 60 && y == 12 ? 200 : 2);
        Scene scene = under(table(DIFFRACTION_ONLY), sun, 512);
        Vector3f expected = new Vector3f(LightList.brightest(scene, RadianceMap.load(pixel.toString()))
                        .towards())
                .rotateZ((float) (Math.PI / 2));
        Scene turned = scene.with(SceneSettings.ENVIRONMENT_ROTATION, Math.PI / 2);
        SceneLight brightest = LightList.brightest(turned, RadianceMap.load(sun.toString()));
        // The region of the pixel is wider than it.
        assertThat(brightest.towards().angle(expected)).isLessThan((float) Math.toRadians(3));
    }

    @Test
    void turningTheEnvironmentTurnsItsLight() {
        Scene scene = under(table(Weights.of(20, 1, 0.8, 0)), "window", 64);
        Quaternionf back = new Quaternionf().rotationZ((float) (-Math.PI / 2));
        Camera camera = scene.view().camera();
        Camera turned = new Camera(
                back.transform(new Vector3f(camera.centerOfProjection())),
                back.transform(new Vector3f(camera.lookAtPoint())),
                back.transform(new Vector3f(camera.up())));
        Scene model = scene.withOrientation(back)
                .withView(new Viewpoint(turned, scene.view().verticalFieldOfView()));
        float[] environment = drawn(scene.with(SceneSettings.ENVIRONMENT_ROTATION, Math.PI / 2), SIZE / 2, SIZE / 2);
        float[] other = drawn(model, SIZE / 2, SIZE / 2);
        assertThat(environment).isNotEqualTo(drawn(scene, SIZE / 2, SIZE / 2));
        double white = Arrays.stream(luminances(environment)).max().orElseThrow();
        int differing = 0;
        for (int i = 0; i < other.length; i++) {
            differing += Math.abs(environment[i] - other[i]) > 1e-3 * white ? 1 : 0;
        }
        // Rounding moves a few footprints to another level or number of taps.
        assertThat(differing).isLessThan(other.length / 100);
    }

    /** The picture by points, of which each has one of the map's own pixels at a time, has the same mean. */
    @Test
    void pointsUnderTheMapsPixelsAgreeWithTheTable() {
        Choices weights = Weights.of(400, 1, 0.8, 0);
        for (String environment : List.of("overcast", "sun")) {
            Scene scene = under(table(weights).with(SceneSettings.ROUGHNESS, Math.toRadians(3)), environment, 512);
            Scene points = scene.withMethod(new SceneMethod(Choices.none().with(METHOD, FullMethod.TYPE)));
            double table =
                    Arrays.stream(luminances(drawn(scene, 16, 16))).average().orElseThrow();
            double drawn =
                    Arrays.stream(luminances(drawn(points, 16, 16))).average().orElseThrow();
            // 256 pixels with 64 lights and slopes each.
            assertThat(table).as(environment).isCloseTo(drawn, within(0.03 * drawn));
        }
    }

    @Test
    void groundHidesLightFromBelow() throws IOException {
        Path below = RadianceFiles.gray(folder.resolve("below.hdr"), 64, 32, (x, y) -> y > 16 ? 127 : 0);
        Optional<RadianceMap> map = Optional.of(RadianceMap.load(below.toString()));
        Scene scene = under(table(Weights.of(0, 1, 1, 0)), below, 64);
        Scene onGround = scene.with(around(Optional.of(new SceneColor(0x808080)), 0, false));
        // Half of all directions, with a white surface that faces them.
        assertThat(LightList.of(scene, map).white()).isCloseTo(WHITE, within(0.05));
        assertThat(LightList.of(onGround, map).white()).isZero();
        float[] drawn = drawn(onGround, SIZE, SIZE);
        assertThat(drawn[4 * (SIZE * SIZE / 2 + SIZE / 2) + 1]).isZero();
    }

    @Test
    void theEnvironmentIsSeenBehindTheModel() throws IOException {
        Scene scene = under(table(Weights.of(0, 1, 1, 0)), white(), 64);
        float[] hidden = drawn(scene, SIZE, SIZE);
        float[] seen = drawn(scene.with(SceneSettings.BACKGROUND, Optional.empty()), SIZE, SIZE);
        // The corner shows no mesh. float32 of colors that go to Rec. 709 and back.
        assertThat(hidden[3]).isZero();
        assertThat((double) seen[1]).isCloseTo(WHITE, within(1e-4));
        assertThat(seen[3]).isCloseTo(1, within(1e-4f));
        Scene without = blaze().with(SceneSettings.BACKGROUND, Optional.empty());
        assertThatThrownBy(() -> load(without))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("the scene has none");
    }

    /** Samples of a pixel have a quarter of the lights each, and together all of them. */
    @Test
    void samplesThatShareTheLightsHaveTheirSum() throws IOException {
        Scene scene = under(table(Weights.of(0, 1, 1, 0)), white(), 256);
        try (SceneSession session = session(scene)) {
            DrawRequest one = DrawRequest.ofPixels(scene, 5, 5, new Tile(2, 2, 1, 1), 1);
            DrawRequest four = DrawRequest.ofPixels(scene, 5, 5, new Tile(2, 2, 1, 1), 2);
            double whole = session.draw(one).rgba()[1];
            float[] samples = session.draw(four).rgba();
            double mean = (samples[1] + samples[5] + samples[9] + samples[13]) / 4.0;
            // The plane's normal is the same at all samples; their directions to the viewer, on which gloss depends,
            // differ.
            assertThat(mean).isCloseTo(whole, within(0.005 * whole));
        }
    }

    /** A bright light, such as the sun, lights all samples; else the edges of its shadows would have one sample. */
    @Test
    void aBrightLightIsSeenByAllSamples() throws IOException {
        Path file = RadianceFiles.gray(folder.resolve("sun.hdr"), 64, 32, (x, y) -> x == 30 && y == 6 ? 255 : 2);
        Scene scene = under(table(Weights.of(0, 1, 1, 0)), file, 256);
        try (SceneSession session = session(scene)) {
            DrawRequest four = DrawRequest.ofPixels(scene, 5, 5, new Tile(2, 2, 1, 1), 2);
            double[] samples = Arrays.stream(luminances(session.draw(four).rgba()))
                    .sorted()
                    .toArray();
            assertThat(samples).hasSize(4);
            // The bright pixel has a seventh of the light on the plane: in one sample alone it would make that one 1.67
            // times as bright.
            // Regions of 4 pi / 256 are 0.22 rad wide. If all of a sample's other lights are turned by that angle, the
            // sum of their
            // cosines changes by at most 0.22 times their sines, in the mean over a hemisphere pi / 2 of the cosines.
            assertThat(samples[3]).isLessThan((1 + 6 / 7.0 * 0.22 * Math.PI / 2) * samples[0]);
        }
    }

    @Test
    void whatHasNoWideLightsIsRefused() {
        Scene scene = blaze().with(SceneSettings.ENVIRONMENT, "window");
        Choices coherent = Choices.none().with(METHOD, TableMethod.TYPE).with(AVERAGE, Average.COHERENT);
        assertThatThrownBy(() -> load(scene.withMethod(new SceneMethod(coherent))))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("give ensemble");
        Choices thesis = Choices.none().with(METHOD, FullMethod.TYPE).with(PRESET, Preset.THESIS);
        assertThatThrownBy(() -> load(scene.withMethod(new SceneMethod(thesis))))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("no environment");
    }
}
