package sunbeam.app.scene.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import jrtr.scene.Light;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.files.InputException;

/** Maps of radiance: files, built-in ones, and the lights that stand for them. */
class RadianceMapTest {
    private static final String KNOWN = "FORMAT=32-bit_rle_rgbe";

    @TempDir
    private Path folder;

    private Path file() {
        return folder.resolve("map.hdr");
    }

    private static List<Light> lights(RadianceMap map, int count) {
        return map.lights().groups(count, 16).stream()
                .flatMap(group -> group.lights().stream())
                .toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"window", "overcast", "sun", "sky"})
    void anyNumberOfLightsHasTheWholeEnergy(String name) {
        RadianceMap map = RadianceMap.load(name);
        for (int count : new int[] {1, 16, 500, 2048}) {
            double sum = lights(map, count).stream()
                    .mapToDouble(LightTree::luminance)
                    .sum();
            // The lights' colors are float32.
            assertThat(Math.PI * sum).as("%d lights", count).isCloseTo(map.luminance(), within(1e-5 * map.luminance()));
        }
        assertThat(lights(map, 500)).hasSize(500);
        double[] drawn = map.lights().pixels(16).stream()
                .flatMap(group -> group.lights().stream())
                .mapToDouble(LightTree::luminance)
                .toArray();
        // Lights that are drawn alike have equal luminance, which bounds the noise of few draws.
        assertThat(drawn).hasSize(2048);
        double each = map.luminance() / 2048;
        var luminances = Arrays.stream(drawn).summaryStatistics();
        assertThat(Math.PI * luminances.getMin()).isCloseTo(each, within(1e-5 * each));
        assertThat(Math.PI * luminances.getMax()).isCloseTo(each, within(1e-5 * each));
    }

    /** Unless dim, whatever faces the brightest side is white, so that a scene's weights suit each. */
    @ParameterizedTest
    @ValueSource(strings = {"window", "overcast", "sun"})
    void aWhiteSurfaceThatFacesTheBrightSideIsWhite(String name) {
        List<Light> lights = lights(RadianceMap.load(name), 2048);
        double white = lights.stream()
                .mapToDouble(facing -> lights.stream()
                        .mapToDouble(light -> LightTree.luminance(light)
                                * Math.max(0, light.towards().dot(facing.towards())))
                        .sum())
                .max()
                .orElseThrow();
        // Normalized with 512 lights; those that straddle the horizon count with their middle.
        assertThat(white).isCloseTo(1, within(0.02));
    }

    @Test
    void onePixelIsOneLightInItsDirection() throws IOException {
        RadianceMap map = RadianceMap.load(RadianceFiles.gray(file(), 64, 32, (x, y) -> x == 48 && y == 8 ? 200 : 0)
                .toString());
        Light light = lights(map, 64).get(0);
        assertThat(lights(map, 64)).hasSize(1);
        // A quarter right of the middle is +x; a quarter below the zenith is 45 degrees: both within half a pixel.
        Vector3f expected = new Vector3f(1, 0, 1).normalize();
        assertThat(light.towards().angle(expected)).isLessThan((float) (Math.PI / 32));
        double solidAngle =
                Math.PI / 32 * Math.PI / 32 * Math.cos(light.towards().angle(new Vector3f(1, 0, 0)));
        // The solid angle of a pixel of 5.6 degrees is nearly its sides' product.
        assertThat(Math.PI * LightTree.luminance(light)).isCloseTo(200.5 / 128 * solidAngle, within(0.01 * solidAngle));
        assertThat(light.deviation()).isBetween(0.02, 0.05);
    }

    @Test
    void theSunIsOneNarrowLight() {
        List<Light> lights = lights(RadianceMap.load("sun"), 64);
        Light brightest = lights.stream()
                .max((a, b) -> Double.compare(LightTree.luminance(a), LightTree.luminance(b)))
                .orElseThrow();
        // The disc's deviation is a quarter of 0.53 degrees; a pixel of 0.35 degrees and the sky close to it add to
        // that.
        assertThat(Math.toDegrees(brightest.deviation())).isLessThan(1);
        assertThat(LightTree.luminance(brightest)).isGreaterThan(0.6);
    }

    /** Half as wide at most, whatever the file: 16384 x 8192 pixels in floats would take 1.6 GB. */
    @Test
    void aLargeFileIsAveraged() throws IOException {
        RadianceMap map =
                RadianceMap.load(RadianceFiles.runs(file(), 16384, 8192, 127).toString());
        assertThat(map.width()).isEqualTo(1024);
        assertThat(map.luminance()).isCloseTo(4 * Math.PI * 127.5 / 128, within(1e-4));
    }

    @Test
    void pixelsAreDividedByTheExposureOfTheirFile() throws IOException {
        byte[] header = RadianceFiles.header(KNOWN + "\nEXPOSURE=0.5", 2, 1);
        RadianceMap map = RadianceMap.load(RadianceFiles.of(file(), header, 127, 127, 127, 129, 127, 127, 127, 129)
                .toString());
        assertThat(map.value(0, 0, 1)).isCloseTo(2 * 127.5f / 128, within(1e-6f));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "FORMAT=32-bit_rle_rgbe              | 3 | 2 | twice as wide as high",
                "FORMAT=32-bit_rle_rgbe              | 0 | 0 | twice as wide as high",
                "FORMAT=32-bit_rle_rgbe              | 65536 | 32768 | at most 32768 wide",
                "FORMAT=32-bit_rle_rgbe              | 1026 | 513 | 513 rows",
                "FORMAT=32-bit_rle_xyze              | 2 | 1 | 32-bit_rle_rgbe",
                "FORMAT=32-bit_rle_rgbe;EXPOSURE=-1  | 2 | 1 | EXPOSURE",
                "FORMAT=32-bit_rle_rgbe;EXPOSURE=NaN | 2 | 1 | EXPOSURE",
                "FORMAT=32-bit_rle_rgbe              | 4 | 2 | ends too early",
            })
    void aWrongHeaderIsRefused(String lines, int width, int height, String reason) throws IOException {
        Path file = RadianceFiles.of(
                file(),
                RadianceFiles.header(lines.replace(";", "\n"), width, height),
                127,
                127,
                127,
                129,
                127,
                127,
                127,
                129);
        assertRefused(file, reason);
    }

    @Test
    void pixelsThatCannotBeAreRefused() throws IOException {
        byte[] header = RadianceFiles.header(KNOWN, 2, 1);
        assertRefused(RadianceFiles.of(file(), header, 0, 0, 0, 0, 0, 0, 0, 0), "is black");
        assertRefused(RadianceFiles.of(file(), header, 9, 9, 9, 255, 9, 9, 9, 129), "has a pixel of");
        assertRefused(RadianceFiles.of(file(), header, 2, 2, 0, 2, 131, 9), "beyond the end of its row");
        assertRefused(RadianceFiles.of(file(), new byte[0], 1, 2, 3, 10), "is no Radiance picture");
    }

    @Test
    void anotherFormatIsRefusedByName() {
        assertRefused(folder.resolve("map.exr"), "convert it to .hdr");
        assertRefused(folder.resolve("none.hdr"), "none.hdr");
    }

    private static void assertRefused(Path file, String reason) {
        assertThatThrownBy(() -> RadianceMap.load(file.toString()))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(file.getFileName().toString())
                .hasMessageContaining(reason)
                .hasMessageNotContaining("\n");
    }
}
