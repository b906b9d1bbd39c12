package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import jrtr.Tile;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.render.PixelPicture.LitPixels;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneMethod;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.setting.Choices;

/**
 * Samples of pixels, their means, and the lit ones among them; shaders/include/footprint.glsl by the variance and the direction of its taps
 * and level.
 */
class PixelSamplesTest extends InAContext {
    /** 480 x 270 had 5 x 5, 16 % fewer in all, and missed its own certificate by a mean CIEDE2000 of 1.1. */
    @ParameterizedTest
    @CsvSource({"320,240,8", "480,270,6", "640,360,4", "800,600,4", "1280,720,4", "3000,2000,4"})
    void aSmallPictureHasMoreSamplesAPixel(int width, int height, int side) {
        assertThat(PixelSamples.of(new SceneMethod(Choices.none()), width, height))
                .satisfies(samples -> {
                    assertThat(samples.side()).isEqualTo(side);
                    // At most 5120 x 2880 samples, or 4 x 4 a pixel if these are more.
                    assertThat(samples.refinements()).isEqualTo(width < 800 ? List.of(side, 2 * side) : List.of(side));
                });
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 6, 8})
    void theFirstSamplesShareNoRowAndNoColumnAndTheirMeanIsThePixelsCenter(int side) {
        assertThat(IntStream.range(0, side).map(row -> PixelSamples.firstColumn(row, side)))
                .hasSize(side)
                .doesNotHaveDuplicates()
                .allMatch(column -> column >= 0 && column < side)
                .satisfies(columns ->
                        assertThat(columns.stream().mapToInt(i -> i).average()).hasValue(0.5 * (side - 1)));
    }

    /** 5120 samples need three blocks of at most 2048, whose sides are no multiples of 4 unless they are rounded; 1300 pixels are prime to 4. */
    @ParameterizedTest
    @CsvSource({"1280,720,4", "1300,701,4", "480,270,6", "2060,24,1"})
    void aTileOfPixelsLiesInOneBlock(int width, int height, int side) {
        SceneBlocks blocks = SceneBlocks.of(side * width, side * height, side);
        for (Tile tile : blocks.tiles(side, 128)) {
            Tile samples = new Tile(side * tile.x(), side * tile.y(), side * tile.width(), side * tile.height());
            assertThat(blocks.split(samples)).as("%s", tile).hasSize(1);
        }
    }

    private static final DisplayTransform CLIP = new DisplayTransform(1, Tone.CLIP);

    /** A mesh of 1000 pixels, some of them white, beside as much white ground. */
    private static ScenePicture specks(int count) {
        ScenePicture picture = ScenePicture.empty(1000, 2);
        for (int pixel = 0; pixel < 1000; pixel++) {
            set(picture, pixel, pixel < count ? 1 : 0, 1);
            set(picture, 1000 + pixel, 1, 0.3f);
        }
        return picture.reduced(1);
    }

    private static void set(ScenePicture picture, int pixel, float light, float opacity) {
        Arrays.fill(picture.rgba(), 4 * pixel, 4 * pixel + 3, light);
        picture.rgba()[4 * pixel + 3] = opacity;
    }

    @Test
    void aBlackMeshWithSpecksHasTooFewWhateverLiesAroundIt() {
        LitPixels specks = LitPixels.of(specks(12), CLIP);

        assertThat(specks.areTooFew()).isTrue();
        assertThat(specks.summary()).isEqualTo("lit: 1.2 % of 1000 pixels that the mesh fills");
        assertThat(specks.complaint()).contains("1.2 %", "move the light");
        assertThat(LitPixels.of(specks(50), CLIP).areTooFew()).isFalse();
        assertThat(LitPixels.of(specks(1000), CLIP).summary()).startsWith("lit: 100 % of");
        LitPixels twoFrames = LitPixels.of(specks(0), CLIP).plus(LitPixels.of(specks(500), CLIP));
        assertThat(twoFrames.share()).isCloseTo(0.25, within(1e-12));
        // 1e-3 of white are three steps of 8 bits, as good as black.
        assertThat(LitPixels.of(specks(500), new DisplayTransform(1e-3, Tone.CLIP))
                        .lit())
                .isZero();
        assertThat(LitPixels.NONE.areTooFew()).isTrue();
        assertThat(LitPixels.NONE.complaint()).contains("shows no mesh");
    }

    @Test
    void theGroundDoesNotCountAsLightOfTheMesh() {
        ScenePicture samples = ScenePicture.empty(2, 2);
        for (int sample = 0; sample < 4; sample++) {
            set(samples, sample, sample == 0 ? 0.25f : 2, sample == 0 ? 1 : 0.75f);
        }

        ScenePicture pixel = samples.reduced(2);

        assertThat(pixel.linear().luminance(0)).isEqualTo(0.25f);
        assertThat(pixel.rgba()[3]).as("coverage").isEqualTo(0.25f);
    }

    private final PixelPicture pixels = new PixelPicture(2, 1, CLIP, new SceneColor(0));

    /** Two columns of four samples, one column for each pixel; the right one has a rim between its rows. */
    private static ScenePicture rim() {
        ScenePicture samples = ScenePicture.empty(2, 4);
        for (int i = 0; i < 8; i++) {
            set(samples, i, i % 2 == 1 && i >= 4 ? 0.5f : 0.2f, 1);
        }
        return samples;
    }

    @Test
    void theMeanAcrossARimIsUnsure() {
        BitSet unsure = pixels.setAll(rim(), 1, 4);

        assertThat(unsure.stream()).containsExactly(1);
        // A mean of two and two samples, within float32.
        assertThat(pixels.light().rgba()[4]).isCloseTo(0.35f, within(1e-6f));
    }

    /** Roots of light of 0 and 1 have a deviation of sqrt(p (1 - p)), their mean of n a standard error of 1 / sqrt(n) of it. */
    @ParameterizedTest
    @CsvSource({"1, 1, true", "0.2, 1, true", "0.02, 1, false", "1, 60, false"})
    void oneOfSixteenSamplesMakesAMeanUnsureIfItIsBrightEnough(float glint, int copies, boolean isUnsure) {
        ScenePicture samples = ScenePicture.empty(8 * copies, 4);
        for (int i = 0; i < 32 * copies; i++) {
            set(samples, i, i == 1 ? glint : 0, 1);
        }
        PixelPicture two = new PixelPicture(2, 1, CLIP, new SceneColor(0));

        BitSet unsure = two.setAll(samples, 4 * copies, 4);

        assertThat(unsure.get(0)).isEqualTo(isUnsure);
        assertThat(unsure.get(1)).as("black").isFalse();
    }

    @Test
    void onlyTheNamedPixelsChange() {
        pixels.setAll(rim(), 1, 4);
        int left = pixels.image().getRGB(0, 0);
        ScenePicture finer = ScenePicture.empty(4, 2);
        Arrays.fill(finer.rgba(), 1);
        BitSet right = new BitSet();
        right.set(1);

        assertThat(pixels.set(right, finer, 2, 2).isEmpty()).as("equal samples").isTrue();

        assertThat(pixels.image().getRGB(0, 0)).isEqualTo(left);
        assertThat(pixels.light().rgba()[0]).isCloseTo(0.2f, within(1e-6f));
        assertThat(pixels.light().rgba()[4]).isEqualTo(1);
    }

    private static final double SIGMA = 1e-3;
    private static final int MOST_TAPS = 8;
    private static final String TEXT = """
        #version 330 core
        #include "include/footprint.glsl"
        uniform vec3 du;
        uniform vec3 dv;
        layout(location = 0) out vec4 color;
        void main() {
            Footprint footprint = footprintOf(vec3(0.3, 0.2, -1.1), du, dv, vec3(0.0, 0.0, 1.0), 0.0, vec3(0.0), 0.0);
            color = gl_FragCoord.x < 1.0 ? vec4(footprint.center, footprint.level) : vec4(footprint.axis, footprint.taps);
        }
        """;

    /** Level, number of taps, and change of u, v, w along them. */
    private record Footprint(int level, int taps, double[] axis) {
        /** Variance along u plus that along v, of the taps and of the level's blur. */
        double variance() {
            double blur = (Math.pow(2, level) - 1) * SIGMA * SIGMA;
            // Taps in the middles of n equal parts.
            return 2 * blur + (1 - 1.0 / (taps * taps)) / 12 * (axis[0] * axis[0] + axis[1] * axis[1]);
        }
    }

    private Footprint find(float[] du, float[] dv, double slope, int pointLevels, int samplesAcross) {
        float[] found = drawn(TEXT, 2, 1, Map.of(), program -> {
            program.set("pointLevels", (float) pointLevels);
            program.set("finestVariance", (float) (SIGMA * SIGMA));
            program.set("levels", 9);
            program.set("mostTaps", (float) MOST_TAPS);
            program.set("samplesAcross", (float) samplesAcross);
            program.set("slopeVariance", (float) (slope * slope));
            program.set("du", new Vector3f(du));
            program.set("dv", new Vector3f(dv));
        });
        return new Footprint((int) found[3], (int) found[7], new double[] {found[4], found[5], found[6]});
    }

    private Footprint find(float[] du, float[] dv) {
        return find(du, dv, 0, 0, 1);
    }

    private static float[] change(double u, double v) {
        return new float[] {(float) (SIGMA * u), (float) (SIGMA * v), (float) (0.5 * SIGMA * (u - v))};
    }

    /**
     * An even parallelogram of sides a and b has the variance (a a^T + b b^T) / 12, whose longer axis taps follow; relief of slope s adds
     * (s w)^2 along both axes.
     */
    @ParameterizedTest
    @CsvSource({
        "8, 0, 0, 8, 0",
        "6, 6, -6, 6, 0",
        "20, 0, 0, 5, 0",
        "9, 7, -7, 9, 0",
        "30, 4, -3, 10, 0",
        "12, 0, 0, 0.1, 0",
        "40, 40, -10, 10, 0",
        "8, 0, 0, 8, 10",
        "20, 0, 0, 5, 30",
        "0, 0, 0, 0, 20"
    })
    void tapsAndLevelTogetherVaryAsThePixelDoes(double ux, double uy, double vx, double vy, double slope) {
        double mesh = SIGMA * SIGMA * (ux * ux + uy * uy + vx * vx + vy * vy) / 12;
        double relief = 2 * Math.pow(slope * 1.1 * SIGMA, 2);

        Footprint footprint = find(change(ux, uy), change(vx, vy), slope * SIGMA, 0, 1);
        double found = footprint.variance();

        // Levels are a factor of 2 apart, and never blur more than the minor axis: nearly half of its variance may be
        // missing.
        assertThat(found).isBetween(0.55 * (mesh + relief), 1.05 * (mesh + relief));
        double turn = Math.atan2(2 * (ux * uy + vx * vy), ux * ux + vx * vx - uy * uy - vy * vy) / 2;
        double[] axis = footprint.axis();
        // float32, where the axes differ in length.
        if (footprint.taps() > 1) {
            assertThat(axis[0] * Math.sin(turn) - axis[1] * Math.cos(turn))
                    .isCloseTo(0, within(1e-5 * Math.hypot(axis[0], axis[1])));
        }
    }

    @Test
    void aLongFootprintHasEightTapsInALevelThatTheyCover() {
        Footprint found = find(change(150, 0), change(0, 1));

        assertThat(found.taps()).isLessThanOrEqualTo(MOST_TAPS);
        double length = Math.hypot(found.axis()[0], found.axis()[1]);
        double shown = SIGMA * Math.pow(2, 0.5 * found.level());
        assertThat(length / found.taps() / shown).as("distance of taps").isLessThanOrEqualTo(1.001 * 1.6);
    }

    @Test
    void onlyPixelsThatSeeLittleMoreThanAPointUseTheLevelForPoints() {
        // A line of that length has a twelfth of its square as variance; the limit is 0.06 of SIGMA's.
        float[] none = change(0, 0);
        float[] shorter = change(0.8, 0);
        float[] longer = change(0.9, 0);
        assertThat(find(none, none, 0, 1, 1).level()).isZero();
        assertThat(find(shorter, none, 0, 1, 1).level()).isZero();
        assertThat(find(longer, none, 0, 1, 1).level()).isOne();
        // A quarter of a pixel.
        assertThat(find(shorter, none, 0, 1, 2).level()).isOne();
        assertThat(find(change(0.4, 0), none, 0, 1, 2).level()).isZero();
        // Without a level for points, level 0 serves them.
        assertThat(find(none, none, 0, 0, 1).level()).isZero();
        assertThat(find(longer, none, 0, 0, 1).level()).isZero();
    }

    /** Differences of (u, v) are multiples of 2^-24: exact squares occur, whose ellipse is a circle. */
    @Test
    void aSquareIsSeenLikeOneThatIsNearlySo() {
        Footprint square = find(change(12, 0), change(0, 12));
        Footprint nearly = find(change(12.001, 0), change(0, 12));
        assertThat(square.level()).isEqualTo(nearly.level());
        assertThat(square.taps()).isEqualTo(nearly.taps());
        // The sides differ by less.
        assertThat(square.variance()).isCloseTo(nearly.variance(), within(1e-3 * nearly.variance()));
    }

    private static final String RELIEF = """
        #version 330 core
        #include "include/gain.glsl"
        uniform vec3 wi;
        uniform vec3 wr;
        uniform float variance;
        layout(location = 0) out vec4 color;
        void main() {
            ReliefMean mean = reliefMean(wi, wr, variance);
            color = vec4(mean.uvw, mean.gain / relativeRadiance(wi, wr));
        }
        """;

    private static Vector3f direction(double theta, double phi) {
        double sine = Math.sin(Math.toRadians(theta));
        double azimuth = Math.toRadians(phi);
        return new Vector3f((float) (sine * Math.cos(azimuth)), (float) (sine * Math.sin(azimuth)), (float)
                Math.cos(Math.toRadians(theta)));
    }

    /** Relative radiance under the normal (x, y, 1), but for factors that no turn changes. */
    private static double radiance(Vector3f wi, Vector3f wr, double x, double y) {
        Vector3f normal = new Vector3f((float) x, (float) y, 1).normalize();
        Vector3f sum = new Vector3f(wi).add(wr);
        double sumZ = normal.dot(sum);
        double wrZ = normal.dot(wr);
        return Math.min(sum.lengthSquared(), 4 * sumZ * Math.min(normal.dot(wi), wrZ)) / (sumZ * sumZ * wrZ);
    }

    /** Beside a sum over slopes of 3 degrees, which weighs each by its radiance; away from the mask's edge, where its mean is lower. */
    @ParameterizedTest
    @CsvSource({"20, 0, 65, 40", "60, 0, 70, 180", "10, 90, 72, 0"})
    void slopesThatShineMoreCountMore(double thetaI, double phiI, double thetaR, double phiR) {
        double deviation = Math.toRadians(3);
        Vector3f wi = direction(thetaI, phiI);
        Vector3f wr = direction(thetaR, phiR);
        double sum = 0;
        double[] slope = new double[2];
        double weights = 0;
        for (double x = -3.95; x < 4; x += 0.1) {
            for (double y = -3.95; y < 4; y += 0.1) {
                double weight = Math.exp(-0.5 * (x * x + y * y));
                double shone = weight * radiance(wi, wr, deviation * x, deviation * y);
                weights += weight;
                sum += shone;
                slope[0] += shone * deviation * x;
                slope[1] += shone * deviation * y;
            }
        }

        float[] mean = drawn(RELIEF, 1, 1, Map.of(), program -> {
            program.set("wi", wi);
            program.set("wr", wr);
            program.set("variance", (float) (deviation * deviation));
        });

        // Third order: a percent of the gain, and of the mean slope a tenth of the deviation.
        assertThat(mean[3]).isCloseTo((float) (sum / weights / radiance(wi, wr, 0, 0)), within(0.01f));
        float w = -wi.z - wr.z;
        assertThat((-wi.x - wr.x - mean[0]) / w).isCloseTo((float) (slope[0] / sum), within((float) (0.1 * deviation)));
        assertThat((-wi.y - wr.y - mean[1]) / w).isCloseTo((float) (slope[1] / sum), within((float) (0.1 * deviation)));
    }
}
