package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;

/** Color tables on meshes: their tolerance, their tiles, and relief finer than a pixel. */
class MeshTableTest extends InAScene {
    /** Returns a scene with a patch of heights in meters, written as text; width and length of its period are in micrometers. */
    private Scene scene(CharSequence heights, double width, double length, String otherKeys) throws IOException {
        Files.writeString(folder.resolve("heights.txt"), heights);
        return Scenes.load(Files.writeString(folder.resolve("scene.json"), Text.format("""
                {
                  "patch": {"file": "heights.txt", "width": "%s um", "height": "%s um", "heightUnit": "m",
                            "levelling": "mean", "edges": "repeat", "periodic": true},
                  "texture": "none",
                  "weights": {"diffraction": 1, "texture": 0},
                  %s
                }
                """, width, length, otherKeys))
                .toString());
    }

    private static final double TOLERANCE = 1e-2;
    private static final int SIDE = 64;
    private static final PixelSamples SAMPLES = PixelSamples.uniform(2);
    private static final int COLUMNS = 200;

    /**
     * Surfaces on which an earlier version missed the tolerance. Windows are shorter than those of sunlight, and periods are not longer
     * than windows, so that tables take seconds.
     *
     * @param width of a period along x, micrometers
     * @param length along y
     * @param lone whether its orders are isolated, so that linear interpolation would miss the tolerance
     */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            ribs   | cylinder   | 5   | 5   | "0 cm", "-80 cm", "30 cm"     | 15 deg  | true
            dots   | sphere     | 0.8 | 1.4 | "0 cm", "-80 cm", "56 cm"     | 20 deg  | true
            blaze  | plane      | 2.5 | 2.5 | "0 cm", "20 cm", "35 cm"      | 60 deg  | true
            rough  | facets.obj | 60  | 60  | "0 cm", "-8000 cm", "5600 cm" | 0.2 deg | false
            """)
    void theToleranceIsKeptAndNoLineSaysOtherwise(
            String surface, String mesh, double width, double length, String eye, String fieldOfView, boolean lone)
            throws IOException {
        Files.writeString(folder.resolve("facets.obj"), FACETS);
        SceneData data = load(scene(
                heights(surface, width, length), width, length, Text.format("""
                "mesh": "%s",
                "camera": {"position": [%s], "lookAt": ["0 cm", "0 cm", "0 cm"], "fieldOfView": "%s"},
                "light": {"direction": [0.3, -0.5, 0.8]},
                "plan": {"coherenceLength": "20 um", "tolerance": %s}
                """, mesh, eye, fieldOfView, TOLERANCE)));
        try (SceneSession session = new SceneSession(context, data)) {
            PartSum sum = new PartSum(List.of(session));
            SceneSession.parts(session.scene(), SIDE, SIDE, SAMPLES).forEach(sum::draw);
            sum.validate();
            ErrorStatistics errors =
                    session.tableErrors(session.scene(), SIDE, SIDE, SAMPLES).orElseThrow();

            assertThat(errors.count()).as("samples with light").isGreaterThan(5);
            assertThat(data.method().colorTable().orElseThrow().table().pointLevelCount())
                    .isEqualTo(lone ? 0 : 1);
            assertThat(errors.keep(TOLERANCE)).as("%s", errors).isTrue();
            assertThat(warnings).noneMatch(line -> line.contains("the table of colors errs"));
        }
    }

    /** Linear interpolation of 1.5 texels errs by 0.05 at the 95th percentile, on flanks of the orders. */
    @Test
    void aWideLightOnARoughDiscKeepsTheTolerance() throws IOException {
        Scene scene = Scenes.load(Files.writeString(folder.resolve("scene.json"), Text.format("""
                {
                  "patch": "disc", "mesh": "disc", "rotatePatch": "90 deg", "texture": "none", "roughness": "1.2 deg",
                  "weights": {"diffraction": 1, "texture": 0},
                  "camera": {"position": ["0 cm", "-30 cm", "22 cm"], "lookAt": ["0 cm", "0 cm", "0 cm"], "fieldOfView": "24 deg"},
                  "light": {"direction": [0.1, 0.42, 0.9], "angularDiameter": "9.5 deg"},
                  "plan": {"coherenceLength": "20 um", "tolerance": %s}
                }
                """, TOLERANCE))
                .toString());
        try (SceneSession session = new SceneSession(context, load(scene))) {
            ErrorStatistics errors =
                    session.tableErrors(scene, SIDE / 2, SIDE / 2, SAMPLES).orElseThrow();

            assertThat(errors.count()).isGreaterThan(50);
            assertThat(errors.keep(TOLERANCE)).as("%s", errors).isTrue();
        }
    }

    private static CharSequence heights(String surface, double width, double length) {
        SplittableRandom random = new SplittableRandom(5);
        DoubleBinaryOperator height = switch (surface) {
            // Of 500 nm, with cross ribs of 5 um; linear interpolation errs by 0.026 in the median.
            case "ribs" -> (x, y) -> 80e-9 * wave(x / 0.5) + 120e-9 * Math.pow(wave(y / 5), 4);
            // Linear interpolation errs by 0.03.
            case "dots" -> MeshTableTest::dots;
            // Mostly dark; linear interpolation errs by 0.1 in the median, and 0.14 at the 95th percentile of its
            // brighter half.
            case "blaze" -> (x, y) -> 1e-7 * x;
            default -> (x, y) -> 40e-9 * random.nextDouble();
        };
        int rows = (int) Math.round(COLUMNS * length / width);
        StringBuilder heights = new StringBuilder();
        for (int i = 0; i < COLUMNS * rows; i++) {
            double meters =
                    height.applyAsDouble(i % COLUMNS * width / COLUMNS, Math.floorDiv(i, COLUMNS) * length / rows);
            heights.append(Text.format("%.4e", meters)).append((i + 1) % COLUMNS == 0 ? '\n' : ' ');
        }
        return heights;
    }

    private static double wave(double turns) {
        return 0.5 + 0.5 * Math.cos(2 * Math.PI * turns);
    }

    /** Hexagonal dots. */
    private static double dots(double x, double y) {
        double nearest = Math.hypot(x - 0.4, y - 0.7);
        for (int corner = 0; corner < 4; corner++) {
            nearest = Math.min(nearest, Math.hypot(x - 0.8 * (corner & 1), y - 0.7 * (corner & 2)));
        }
        return 150e-9 * Math.sqrt(Math.max(0, 1 - Math.pow(nearest / 0.3, 2)));
    }

    /** A pyramid of four faces, each with its normal. */
    private static final String FACETS = """
            v 0 0 0.05
            v 0.1 0 0
            v 0 0.1 0
            v -0.1 0 0
            v 0 -0.1 0
            vt 0 0
            vt 1 0
            vt 0 1
            vn 0.4082 0.4082 0.8165
            vn -0.4082 0.4082 0.8165
            vn -0.4082 -0.4082 0.8165
            vn 0.4082 -0.4082 0.8165
            f 2/1/1 3/2/1 1/3/1
            f 3/1/2 4/2/2 1/3/2
            f 4/1/3 5/2/3 1/3/3
            f 5/1/4 2/2/4 1/3/4
            """;

    /** A viewer shows a picture as soon as its own tiles are there; the rest of the table comes later. */
    @Test
    void aPictureWaitsForNoOtherTiles() {
        Scene rough = blaze().withMethod(new SceneMethod(Choices.none().with(Methods.METHOD, TableMethod.TYPE)))
                .with(SceneSettings.ROUGHNESS, Math.toRadians(9));
        Deque<Runnable> work = new ArrayDeque<>();
        try (SceneSession session = session(rough);
                SceneSession whole = session(rough)) {
            VirtualTexture tiles = session.virtualTexture().orElseThrow();
            tiles.bakeOn(work::add, () -> {});
            assertThat(session.request(MIRROR_SIDE, MIRROR_SIDE, PixelSamples.uniform(1), () -> false))
                    .isTrue();
            while (tiles.requestedShare() < 1) {
                work.remove().run();
                tiles.drain();
            }
            assertThat(tiles.isComplete()).isFalse();
            float[] waited = picture(session, MIRROR_SIDE, MIRROR_SIDE).rgba();
            float[] drawn = picture(whole, MIRROR_SIDE, MIRROR_SIDE).rgba();
            assertThat(whole.virtualTexture().orElseThrow().isComplete()).isTrue();
            // The same tiles, and so the same bits.
            assertThat(Arrays.equals(waited, drawn)).isTrue();
        }
    }

    private static final int MIRROR_SIDE = 24;
    // Angle between the normal and both light and camera, so that |w| is around 1.44.
    private static final double TILT = Math.toRadians(44);
    // Tangent of half the angle across a picture of 4:3 and of 14 degrees from top to bottom; a square is as wide.
    private static final double HALF_WIDTH = Math.tan(Math.toRadians(7)) * 4 / 3;
    // Standard deviation of a sharp order at a point, in (u, v), at 550 nm: of sunlight's window.
    private static final double POINT_SIGMA = 0.0038;
    // Largest exponent of the distribution: flanks with an eighth of the peak's light.
    private static final double LARGEST_EXPONENT = 2;

    /** The mirror's highlight is the normal distribution of the slopes, white and without edges, at each width. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.2, 1.7, 3})
    void theHighlightOfAMirrorIsTheDistributionOfItsSlopes(double roughness) throws IOException {
        float[] xyz = drawn(mirror(roughness), MIRROR_SIDE, MIRROR_SIDE);
        double slopes = Math.tan(Math.toRadians(roughness));
        List<Double> ratios = new ArrayList<>();
        for (int i = 0; i < MIRROR_SIDE * MIRROR_SIDE; i++) {
            double[] uvw = uvw(i % MIRROR_SIDE, Math.floorDiv(i, MIRROR_SIDE));
            double square = uvw[0] * uvw[0] + uvw[1] * uvw[1];
            double variance = Math.pow(slopes * uvw[2], 2) + Math.pow(POINT_SIGMA, 2);
            double exponent = square / (2 * variance);
            double sum = square + uvw[2] * uvw[2];
            // Radiance per power: shaders/include/gain.glsl, without its Fresnel factor.
            double gain = sum * sum / (uvw[2] * uvw[2] * (uvw[2] - Math.cos(TILT)));
            if (exponent < LARGEST_EXPONENT) {
                ratios.add(xyz[4 * i + 1] / (gain * Math.exp(-exponent) / variance));
                // White of equal energy: orders at a point are wider in red, by 1 % of this width.
                assertThat(xyz[4 * i] / xyz[4 * i + 1]).isBetween(0.97f, 1.01f);
            }
        }
        assertThat(ratios).as("pixels").hasSizeGreaterThan(50);
        // The Fresnel factor, which varies by 10 % over the widest highlight, and the table's error on flanks.
        assertThat(Collections.max(ratios) / Collections.min(ratios)).isLessThan(1.15);
        assertThat(warnings).noneMatch(line -> line.contains("roughness"));
    }

    /** The levels of a table are steps of brightness there. */
    @Test
    void aWarningTellsOfSlopesTooSmallForATable() throws IOException {
        load(mirror(0.5));
        assertThat(warnings).anyMatch(line -> line.startsWith("heights: roughness 0.50 deg: "));
    }

    /** Returns u, v and |w| of a pixel, whose distance from the mirror direction is that of its line of sight from the middle one. */
    private static double[] uvw(int column, int row) {
        double right = HALF_WIDTH * ((column + 0.5) / MIRROR_SIDE * 2 - 1);
        double up = HALF_WIDTH * (1 - (row + 0.5) / MIRROR_SIDE * 2);
        double y = Math.sin(TILT) + up * Math.cos(TILT);
        double z = Math.cos(TILT) - up * Math.sin(TILT);
        double length = Math.sqrt(right * right + y * y + z * z);
        return new double[] {right / length, y / length - Math.sin(TILT), z / length + Math.cos(TILT)};
    }

    private Scene mirror(double roughness) throws IOException {
        return scene(
                "0 0 0 0\n0 1e-12 0 0\n0 0 0 0\n0 0 0 0\n",
                2,
                2,
                Text.format("""
                "mesh": "plane",
                "camera": {"position": ["0 cm", "%s cm", "%s cm"], "lookAt": ["0 cm", "0 cm", "0 cm"], "up": [0, 0, 1],
                           "fieldOfView": "14 deg"},
                "light": {"direction": [0, %s, %s]},
                "roughness": "%s deg"
                """, -20 * Math.sin(TILT), 20 * Math.cos(TILT), Math.sin(TILT), Math.cos(TILT), roughness));
    }
}
