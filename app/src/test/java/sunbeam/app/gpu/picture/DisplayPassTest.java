package sunbeam.app.gpu.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.ShaderProgram;
import jrtr.Tile;
import jrtr.glsl.ShaderLibrary;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.files.output.SrgbImage;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.Shaders;

/** The way from linear XYZ to sRGB, on the GPU, against {@link Srgb} in double precision. */
@NeedsDisplay
class DisplayPassTest extends InAContext {
    // Half a unit of the last place of numbers below 1.
    private static final double ROUNDING = Math.pow(2, -24);
    // GLSL 4.60, section 4.7.1: pow is exp2(y log2 x), log2 to 3 units of the last place and exp2 to 3 + 2 |y log2 x|.
    // On the curve log2 x lies in (-8.4, 0], whose last place is 2^-20, y is 1 / 2.4, and y log2 x below 3.5:
    // 3 * 2^-20 * ln 2 / 2.4 + 10 * 2^-23 of the power, times 1.055.
    private static final double POWER = 1.055 * (3 * Math.pow(2, -20) * Math.log(2) / 2.4 + 10 * Math.pow(2, -23));
    // The shader's matrices have seven digits behind the point.
    private static final double DIGITS = 0.5e-7;

    private static float[] shown(List<Vector3d> colors, double exposure) {
        float[] xyz = new float[3 * colors.size()];
        for (int i = 0; i < colors.size(); i++) {
            xyz[3 * i] = (float) colors.get(i).x;
            xyz[3 * i + 1] = (float) colors.get(i).y;
            xyz[3 * i + 2] = (float) colors.get(i).z;
        }
        try (DisplayPass display = new DisplayPass(context)) {
            return display.srgb(new LinearPicture(colors.size(), 1, xyz), exposure);
        }
    }

    private static Vector3d asFloats(Vector3d color) {
        return new Vector3d((float) color.x, (float) color.y, (float) color.z);
    }

    /** All chromaticities, those that no light has too, and all luminances; then XYZ that have no chromaticity. */
    private static List<Vector3d> grid() {
        double[] luminances = {1e-7, 1e-4, 0.003, 0.0032, 0.02, 0.2, 0.5, 0.9, 0.999, 1, 1.001, 3, 1e4, 1e12, -1e-3, -2
        };
        List<Vector3d> colors = new ArrayList<>();
        for (double luminance : luminances) {
            for (double x = -0.15; x < 1.1; x += 0.05) {
                for (double y = -0.125; y < 1.1; y += 0.05) {
                    colors.add(new Vector3d(x / y, 1, (1 - x - y) / y).mul(luminance));
                }
            }
        }
        double[] sides = {-1e6, -1, -0.01, 0, 1e-5, 0.3, 1, 40, 1e7, 1e30};
        for (double x : sides) {
            for (double y : sides) {
                for (double z : sides) {
                    colors.add(new Vector3d(x, y, z));
                }
            }
        }
        return colors;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.004, 217})
    void everyColourIsTheStandardsOnceItsSaturationFits(double exposure) {
        List<Vector3d> colors = grid();

        float[] srgb = shown(colors, exposure);

        for (int i = 0; i < colors.size(); i++) {
            Vector3d exposed = asFloats(colors.get(i)).mul((float) exposure);
            Vector3d rgb = Srgb.fromXyz().transform(new Vector3d(exposed));
            Vector3d expected = Srgb.shown(rgb, exposed.y);
            double tolerance = linearTolerance(exposed, rgb);
            for (int c = 0; c < 3; c++) {
                double low = Srgb.encoded(Math.max(0, expected.get(c) - tolerance));
                double high = Srgb.encoded(Math.min(1, expected.get(c) + tolerance));
                assertThat((double) srgb[3 * i + c])
                        .as("channel %d of %s at exposure %s", c, colors.get(i), exposure)
                        .isBetween(low - POWER, high + POWER);
            }
        }
    }

    /**
     * What float32 may do to a linear channel. Exposure, product with the matrix and the difference to the luminance are
     * up to six roundings of the largest number in them. The saturation that is kept, room / chroma, takes over the
     * relative error of the chroma that limits it, and hands it to the other channels.
     */
    private static double linearTolerance(Vector3d exposed, Vector3d rgb) {
        // The matrix's rows have absolute values of up to 3.2, 1.9 and 1.1.
        double largest = 3.3 * (Math.abs(exposed.x) + Math.abs(exposed.y) + Math.abs(exposed.z));
        double chromaError = 6 * ROUNDING * largest + DIGITS * largest;
        double share = Srgb.share(rgb, exposed.y);
        // Weights 0.07 to 0.72 of the channels in the luminance: no chroma is 13 times the largest of the other sign.
        return 14 * (share * chromaError + 2 * ROUNDING);
    }

    @Test
    void everyColourOfADisplayComesBackToTheByte() {
        Random random = new Random(23);
        List<Integer> bytes = new ArrayList<>();
        for (int grey = 0; grey < 256; grey++) {
            bytes.add(grey * 0x010101);
        }
        random.ints(2000, 0, 0x1000000).forEach(bytes::add);
        List<Vector3d> colors = bytes.stream()
                .map(rgb -> Srgb.toXyz()
                        .transform(new Vector3d(
                                Srgb.decoded((rgb >> 16) / 255.0),
                                Srgb.decoded((rgb >> 8 & 0xff) / 255.0),
                                Srgb.decoded((rgb & 0xff) / 255.0))))
                .toList();

        BufferedImage image = SrgbImage.fromEncoded(colors.size(), 1, shown(colors, 1));

        for (int i = 0; i < colors.size(); i++) {
            assertThat(image.getRGB(i, 0) & 0xffffff).isEqualTo(bytes.get(i));
        }
    }

    @Test
    void whereSaturationGoesHueAndLuminanceStay() {
        List<Vector3d> colors = new ArrayList<>();
        Random random = new Random(7);
        for (int i = 0; i < 500; i++) {
            colors.add(new Vector3d(random.nextDouble(), random.nextDouble(), 1.5 * random.nextDouble()));
        }

        float[] srgb = shown(colors, 1);

        for (int i = 0; i < colors.size(); i++) {
            double luminance = (float) colors.get(i).y;
            Vector3d chroma = Srgb.fromXyz().transform(asFloats(colors.get(i))).sub(luminance, luminance, luminance);
            Vector3d linear = new Vector3d(
                    Srgb.decoded(srgb[3 * i]), Srgb.decoded(srgb[3 * i + 1]), Srgb.decoded(srgb[3 * i + 2]));
            // The curve's inverse is at most 2.3 times as steep as the straight line; the rest as in linearTolerance.
            double tolerance = 2.3 * POWER + 14 * 30 * ROUNDING;
            assertThat(Srgb.toXyz().transform(new Vector3d(linear)).y).isCloseTo(luminance, within(tolerance));
            Vector3d kept = linear.sub(luminance, luminance, luminance);
            assertThat(kept.cross(chroma, new Vector3d()).length())
                    .as("hue of %s", colors.get(i))
                    .isLessThan(2 * tolerance * chroma.length());
            assertThat(kept.dot(chroma)).isGreaterThanOrEqualTo(-tolerance * chroma.length());
        }
    }

    @Test
    void whatIsBrighterThanWhiteIsWhiteHoweverBright() {
        List<Vector3d> colors = new ArrayList<>();
        for (double brightness = 1.01; brightness < 1e37; brightness *= 9.7) {
            // Greys are the hard ones: their chroma is nothing but rounding, of either sign.
            colors.add(new Vector3d(Srgb.WHITE).mul(brightness));
            colors.add(new Vector3d(0.950456, 1, 1.089058).mul(brightness));
            colors.add(new Vector3d(0.2, 1, 3).mul(brightness));
        }
        double infinity = Double.POSITIVE_INFINITY;
        colors.add(new Vector3d(infinity, infinity, infinity));

        for (float value : shown(colors, 1)) {
            assertThat((double) value).isBetween(1 - POWER, 1.0);
        }
    }

    @Test
    void withoutLuminanceNothingIsShown() {
        List<Vector3d> colors = List.of(
                new Vector3d(0, 0, 0), new Vector3d(5, 0, 3), new Vector3d(0.4, -1e-6, 0.1), new Vector3d(-1, -1, -1));

        assertThat(shown(colors, 3)).containsOnly(0);
    }

    @Test
    void pixelsStayWhereTheyAreAndThoseWithoutSurfaceHaveNoColour() {
        float[] xyz = new float[3 * 3 * 2];
        Arrays.fill(xyz, Float.NaN);
        // Row 0, column 2: white; row 1, column 0: the grey that half of white's luminance makes.
        for (int c = 0; c < 3; c++) {
            xyz[3 * 2 + c] = (float) Srgb.WHITE.get(c) * 1.01f;
            xyz[3 * 3 + c] = (float) Srgb.WHITE.get(c) * 0.5f;
        }

        float[] srgb;
        try (DisplayPass display = new DisplayPass(context)) {
            // Another size before: what is kept of it must not show.
            display.srgb(new LinearPicture(1, 1, new float[] {9, 9, 9}), 1);
            srgb = display.srgb(new LinearPicture(3, 2, xyz), 1);
        }

        for (int pixel = 0; pixel < 6; pixel++) {
            for (int c = 0; c < 3; c++) {
                float value = srgb[3 * pixel + c];
                switch (pixel) {
                    case 2 -> assertThat((double) value).isCloseTo(1, within(POWER));
                    // 1e-5: seven digits of the matrix, float32 and the curve.
                    case 3 -> assertThat((double) value).isCloseTo(Srgb.encoded(0.5), within(1e-5));
                    default -> assertThat(value).isNaN();
                }
            }
        }
    }

    @Test
    void theShadersMatricesAreTheStandardsAndEachOthersInverse() {
        String text = """
                #version 330 core
                #include "include/srgb.glsl"
                layout(location = 0) out vec4 color;
                void main() {
                    int column = int(gl_FragCoord.x);
                    vec3 unit = vec3(column % 3 == 0, column % 3 == 1, column % 3 == 2);
                    color.rgb = column < 3 ? LINEAR_SRGB_TO_XYZ * unit : XYZ_TO_LINEAR_SRGB * (LINEAR_SRGB_TO_XYZ * unit);
                }
                """;
        ShaderLibrary library = name -> name.equals("matrices.frag") ? Optional.of(text) : Optional.empty();
        float[] pixels;
        try (ShaderProgram program = context.createFullScreenProgram(
                        library.orElse(Shaders.library()).load("matrices.frag"));
                FloatTarget target = context.createFloatTarget("matrices", FloatTargetSpec.color(6, 1))) {
            context.drawFullScreen(program, List.of(), target, Tile.whole(6, 1));
            pixels = target.read(0);
        }

        for (int column = 0; column < 3; column++) {
            for (int row = 0; row < 3; row++) {
                assertThat((double) pixels[4 * column + row])
                        .isCloseTo(Srgb.toXyz().get(column, row), within(DIGITS + ROUNDING));
                // Three products of seven digits and coefficients of up to 3.2.
                assertThat((double) pixels[4 * (column + 3) + row])
                        .isCloseTo(row == column ? 1 : 0, within(3 * 3.3 * (2 * DIGITS + 2 * ROUNDING)));
            }
        }
    }
}
