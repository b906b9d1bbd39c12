package sunbeam.app.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import jrtr.gl.FloatTexture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.cli.FileCommand;
import sunbeam.app.gpu.InAContext;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;

/** Automatic exposure with any formula: the subject is lit, the exposure never jumps (docs/theory.md); doubtful pictures; and the display shader. */
class AutoExposureTest extends InAContext {
    // Luminances are float32.
    private static final double ROUNDING = 1e-6;

    private static LinearPicture picture(double... luminances) {
        float[] xyz = new float[3 * luminances.length];
        for (int i = 0; i < luminances.length; i++) {
            // X and Z vary; the exposure must not depend on them.
            xyz[3 * i] = (float) (luminances[i] * (i % 7));
            xyz[3 * i + 1] = (float) luminances[i];
            xyz[3 * i + 2] = (float) (luminances[i] * (i % 3) - 5);
        }
        return new LinearPicture(luminances.length, 1, xyz);
    }

    private static double exposure(double... luminances) {
        return LinearPicture.exposure(picture(luminances));
    }

    /** Spread over two decades, as diffracted light is, in no order. */
    private static double[] diffraction(int pixels) {
        return new Random(5).doubles(pixels, -2, 0).map(x -> Math.pow(10, x)).toArray();
    }

    private static double[] joined(double[] first, double... more) {
        return Stream.of(first, more).flatMapToDouble(DoubleStream::of).toArray();
    }

    private static double[] repeated(int times, double value) {
        return DoubleStream.generate(() -> value).limit(times).toArray();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-30, 1e-6, 0.7, 3e5, 1e30})
    void anEvenPictureIsDrawnAtTheTarget(double luminance) {
        assertThat(exposure(repeated(50, luminance)) * luminance)
                .isCloseTo(LinearPicture.EXPOSURE_TARGET, within(LinearPicture.EXPOSURE_TARGET * ROUNDING));
        assertThat(exposure(luminance) * luminance)
                .as("one pixel")
                .isCloseTo(LinearPicture.EXPOSURE_TARGET, within(LinearPicture.EXPOSURE_TARGET * ROUNDING));
    }

    @Test
    void theBrighterHalfDeterminesTheExposure() {
        double[] luminances = diffraction(5000);
        double[] sorted = Arrays.stream(luminances).sorted().toArray();

        double well = LinearPicture.EXPOSURE_TARGET / exposure(luminances);

        // Half of the lightness lies below this rank of a distribution that is even in log Y: the share of lightness
        // below rank r is (100^(r/3) - 1) / (100^(1/3) - 1).
        assertThat(well).isBetween(sorted[(int) (0.67 * 5000)], sorted[(int) (0.98 * 5000)]);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-12, 0.25, 1e9})
    void brighterLightIsExposedLessInProportion(double factor) {
        double[] luminances = diffraction(400);
        double[] brighter = Arrays.stream(luminances).map(y -> factor * y).toArray();

        assertThat(factor * exposure(brighter) / exposure(luminances)).isCloseTo(1, within(ROUNDING));
    }

    @Test
    void aLoneOrderOnBlackIsDrawnAtTheTarget() {
        // 0.5 % of the picture, over a ground 1e9 times darker.
        double[] order = repeated(50, 0.1);

        assertThat(exposure(joined(order, repeated(9950, 1e-10))) * 0.1)
                .isCloseTo(LinearPicture.EXPOSURE_TARGET, within(0.01));
    }

    @Test
    void theExposureWithoutLightIsOne() {
        assertThat(exposure(repeated(20, 0))).as("black").isEqualTo(1);
        assertThat(exposure(repeated(20, Double.NaN))).as("no surface").isEqualTo(1);
        assertThat(exposure(repeated(20, -1e-9))).as("rounded below zero").isEqualTo(1);
        assertThat(exposure()).as("no pixel").isEqualTo(1);
        assertThat(LinearPicture.exposure()).as("no picture").isEqualTo(1);
    }

    @Test
    void pixelsThatAreNoNumbersDoNotCount() {
        double[] luminances = diffraction(400);

        assertThat(exposure(joined(luminances, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -3)))
                .isEqualTo(exposure(luminances));
    }

    private static final Patch STEP = patch(1e-7);

    private static Patch patch(double step) {
        HeightMap map = new HeightMap(2, 1, 1e-7, 1e-7, new double[] {0, step});
        return new Patch(
                "step", map, map, "made up", List.of(), List.of(), List.of(), List.of(), Patch.Repetition.PERIODIC);
    }

    private static BufferedImage lit() {
        BufferedImage image = new BufferedImage(32, 32, BufferedImage.TYPE_INT_RGB);
        image.setRGB(3, 5, 0x000001);
        return image;
    }

    private final StringWriter said = new StringWriter();

    private int judge(Patch patch, BufferedImage image, boolean automatic) {
        boolean black = FileCommand.isBlack(image);
        return FileCommand.doubt(List.of(STEP, patch), black, "the map", automatic, new PrintWriter(said))
                .code();
    }

    @Test
    void theMapOfAMirrorIsDoubtful() {
        assertThat(judge(patch(0), lit(), false)).isEqualTo(3);
        // Half a nanometer: 7e-5 of the light at most.
        assertThat(judge(patch(0.5e-9), lit(), false)).isEqualTo(3);
        assertThat(judge(STEP, lit(), false)).isZero();
        assertThat(said.toString()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"false, let the exposure be automatic", "true, move the light"})
    void aBlackMapIsDoubtfulAndSaysWhatHelps(boolean automatic, String remedy) {
        assertThat(judge(STEP, new BufferedImage(32, 32, BufferedImage.TYPE_INT_RGB), automatic))
                .isEqualTo(3);
        assertThat(said.toString())
                .contains("warning: the map is black all over")
                .contains(remedy);
    }

    // The shader's matrices have seven digits behind the point, its numbers 24 bits.
    private static final double DIGITS = 1e-7;

    /** All chromaticities, also impossible ones, at luminances from black to infinitely bright; some colors without luminance. */
    private static List<float[]> colors() {
        List<float[]> colors = new ArrayList<>();
        for (double luminance : new double[] {1e-7, 0.003, 0.2, 0.5, 0.999, 1.001, 3, 100, 1e4, 1e12, -1e-3}) {
            for (double x = -0.05; x < 0.9; x += 0.05) {
                for (double y = 0.025; y < 1; y += 0.05) {
                    double scale = luminance / y;
                    colors.add(new float[] {(float) (scale * x), (float) luminance, (float) (scale * (1 - x - y)), 1});
                }
            }
        }
        return colors;
    }

    @ParameterizedTest
    @CsvSource({"1, COMPRESS", "0.004, COMPRESS", "217, COMPRESS", "1, CLIP", "217, CLIP"})
    void movingPicturesLookLikeStillOnes(double exposure, Tone tone) {
        String shader = """
                #version 330 core
                #include "include/display.glsl"
                uniform sampler2D xyz;
                layout(location = 0) out vec4 color;
                void main() { color = vec4(displayLight(texelFetch(xyz, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }
                """;
        List<float[]> colors = colors();
        float[] texels = new float[4 * colors.size()];
        for (int i = 0; i < colors.size(); i++) {
            System.arraycopy(colors.get(i), 0, texels, 4 * i, 4);
        }
        float[] shown;
        try (FloatTexture texture = context.createFloatTexture(
                "xyz", FloatTexture.Spec.flat(colors.size(), 1, FloatTexture.Format.RGBA32F))) {
            texture.upload(texels);
            shown = drawn(shader, colors.size(), 1, Map.of("xyz", texture), program -> {
                program.set("exposure", (float) exposure);
                program.set("toneStart", (float) tone.start());
            });
        }
        double[] expected = new double[3];
        for (int i = 0; i < colors.size(); i++) {
            new DisplayTransform(exposure, tone).light(colors.get(i), 0, expected);
            float[] xyz = colors.get(i);
            // Channels are differences of numbers this many times the luminance, towards whose gray a color moves.
            double cancellation =
                    3.3 * (Math.abs(xyz[0]) + Math.abs(xyz[1]) + Math.abs(xyz[2])) / Math.max(xyz[1], 1e-30f);
            for (int c = 0; c < 3; c++) {
                assertThat((double) shown[4 * i + c])
                        .as("channel %d of %s", c, java.util.Arrays.toString(xyz))
                        .isCloseTo(expected[c], within(20 * DIGITS * cancellation * Math.max(1, expected[c])));
            }
        }
    }
}
