package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Colors as a display shows them, and their differences. */
class DisplayTransformTest {
    // XYZ are floats, and matrices have seven digits behind the point.
    private static final double ROUNDING = 2e-6;

    private static double[] light(double[] xyz, double exposure, Tone tone) {
        double[] rgb = new double[3];
        new DisplayTransform(exposure, tone)
                .light(new float[] {(float) xyz[0], (float) xyz[1], (float) xyz[2]}, 0, rgb);
        return rgb;
    }

    @ParameterizedTest
    @EnumSource(names = {"COMPRESS", "CLIP"})
    void colorsWithinTheGamutStay(Tone tone) {
        double[] dim = {0.4, 0.1, 0.3};

        assertThat(light(Srgb.xyz(dim[0], dim[1], dim[2]), 1, tone)).containsExactly(dim, within(ROUNDING));
        assertThat(light(Srgb.xyz(4, 1, 3), 0.1, tone)).containsExactly(dim, within(ROUNDING));
        assertThat(light(Srgb.xyz(3, 0.5, 1.5), 1, Tone.CLIP))
                .as("clipped one by one")
                .containsExactly(new double[] {1, 0.5, 1}, within(ROUNDING));
    }

    @Test
    void highlightsKeepTheRatioOfTheirChannels() {
        for (double brightness = 1; brightness <= 10; brightness *= 1.5) {
            double[] rgb = light(Srgb.xyz(1, 0.4, 0.1), brightness, Tone.COMPRESS);

            // A hundred times white loses a third of its saturation, ten times 5 %.
            assertThat(rgb[1] / rgb[0]).isCloseTo(0.4, within(0.03));
            assertThat(rgb[2] / rgb[0]).isCloseTo(0.1, within(0.045));
        }
    }

    @Test
    void brighterIsNeverDarkerAndNothingReachesWhiteBelowFiftyTimesWhite() {
        double before = 0;
        for (double brightness = 1e-3; brightness < 1e6; brightness *= 1.01) {
            double[] rgb = light(Srgb.xyz(0.9, 1, 0.2), brightness, Tone.COMPRESS);
            double largest = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
            assertThat(largest).isGreaterThanOrEqualTo(before - ROUNDING).isLessThanOrEqualTo(1);
            // 254.5 of 255 is 0.9956 of white.
            assertThat(brightness > 50 || largest < 0.9956).isTrue();
            before = largest;
        }
    }

    /** Its program's curve is 1.055 x^(1 / 2.5) - 0.055. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.18, 0.5, 1, 3})
    void theThesissGammaIsThatOfItsProgram(double gray) {
        double expected = 255 * (1.055 * Math.pow(Math.min(1, gray), 1 / 2.5) - 0.055);
        int shown = new DisplayTransform(1, Tone.GAMMA).rgb(Srgb.xyz(gray, gray, gray)) & 0xff;
        // Half a step of 8 bits, and the rounding of the matrices.
        assertThat((double) shown).isCloseTo(expected, within(0.501));
        assertThat(Tone.GAMMA.before(Srgb.linear(expected))).isCloseTo(Math.min(1, gray), within(ROUNDING));
    }

    @ParameterizedTest
    @EnumSource(names = {"COMPRESS", "CLIP"})
    void colorsOutsideOfTheGamutKeepLuminanceAndLoseSaturationAlone(Tone tone) {
        Random random = new Random(7);
        for (int i = 0; i < 500; i++) {
            double[] xyz = {0.1 * random.nextDouble(), 0.1 * random.nextDouble(), 0.1 * random.nextDouble()};
            double[] rgb = light(xyz, 1, tone);
            double largest = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
            if (largest < Tone.COMPRESS.start()) {
                assertThat(Srgb.xyz(rgb[0], rgb[1], rgb[2])[1]).isCloseTo(xyz[1], within(ROUNDING));
            }
            assertThat(Math.min(rgb[0], Math.min(rgb[1], rgb[2]))).isGreaterThanOrEqualTo(0);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "-1, 0", "NaN, 0", "Infinity, 1"})
    void colorsWithoutLuminanceAreBlackAndInfiniteLightIsWhite(double luminance, double shown) {
        double other = luminance > 1 ? luminance : 1;
        assertThat(light(new double[] {other, luminance, other}, 1, Tone.COMPRESS))
                .containsExactly(shown, shown, shown);
    }

    /** White of equal energy has equal channels by the CIE's definition; D65 gets little red; its blue is cut at 1. */
    @Test
    void theThesisSPrimariesAreTheCies() {
        double[] rgb = new double[3];
        DisplayTransform thesis = new DisplayTransform(0.5, Tone.CLIP, Primaries.CIE_RGB);

        thesis.light(new float[] {1, 1, 1}, 0, rgb);
        // The matrix has eight decimals; float32 has seven digits.
        assertThat(rgb).containsExactly(new double[] {0.5, 0.5, 0.5}, within(1e-7));
        thesis.light(new float[] {1.9009f, 2, 2.1777f}, 0, rgb);
        // 2.3646 x 0.95047 - 0.8965 - 0.4681 x 1.08883 = 0.841.
        assertThat(rgb).containsExactly(new double[] {0.8412, 1, 1}, within(1e-4));
    }

    @Test
    void everyColorOfADisplayComesBackToTheByteWhereNothingIsCompressed() {
        Random random = new Random(23);
        random.ints(2000, 0, 0x1000000).forEach(rgb -> {
            double[] xyz = Srgb.xyz(Srgb.linear(rgb >> 16), Srgb.linear(rgb >> 8 & 0xff), Srgb.linear(rgb & 0xff));
            assertThat(new DisplayTransform(1, Tone.CLIP).rgb(xyz)).isEqualTo(rgb);
        });
    }

    /** By IEC 61966-2-1, whose pieces meet at 0.0031308. */
    @Test
    void channelsAreRoundedToTheNearest() {
        for (double linear = 0; linear <= 1; linear += 1.7e-4) {
            double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
            assertThat(Srgb.channel(linear)).isEqualTo((int) Math.round(255 * encoded));
        }
        assertThat(List.of(Srgb.channel(-3), Srgb.channel(Double.NaN))).containsOnly(0);
        assertThat(Srgb.channel(Double.POSITIVE_INFINITY)).isEqualTo(255);
    }

    @Test
    void whiteIsD65AndPrimariesHaveTheirChromaticities() {
        // ASTM E308, D65 and the 2 degree observer; half a unit of the matrix's last place in each of three terms.
        assertThat(Srgb.xyz(1, 1, 1)).containsExactly(new double[] {0.95047, 1, 1.08883}, within(1.5e-6));
        double[][] chromaticities = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
        for (int i = 0; i < 3; i++) {
            double[] xyz = Srgb.xyz(i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0);
            double sum = xyz[0] + xyz[1] + xyz[2];
            // Seven digits of numbers whose sum is 0.64 at least.
            assertThat(xyz[0] / sum).isCloseTo(chromaticities[i][0], within(3e-7));
            assertThat(xyz[1] / sum).isCloseTo(chromaticities[i][1], within(3e-7));
        }
    }

    // Half of the table's last digit, for colors and differences.
    private static final double PUBLISHED_DIGITS = 1e-4;

    /** Sharma, Wu, Dalal 2005, table 1: hue differences beyond 180 degrees, grays, blues, near and far pairs. */
    @ParameterizedTest
    @CsvSource({
        "50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425",
        "50, 3.1571, -77.2803, 50, 0, -82.7485, 2.8615",
        "50, 2.8361, -74.0200, 50, 0, -82.7485, 3.4412",
        "50, -1.3802, -84.2814, 50, 0, -82.7485, 1.0000",
        "50, -1.1848, -84.8006, 50, 0, -82.7485, 1.0000",
        "50, -0.9009, -85.5211, 50, 0, -82.7485, 1.0000",
        "50, 0, 0, 50, -1, 2, 2.3669",
        "50, 2.4900, -0.0010, 50, -2.4900, 0.0009, 7.1792",
        "50, 2.4900, -0.0010, 50, -2.4900, 0.0010, 7.1792",
        "50, 2.4900, -0.0010, 50, -2.4900, 0.0011, 7.2195",
        "50, 2.4900, -0.0010, 50, -2.4900, 0.0012, 7.2195",
        "50, -0.0010, 2.4900, 50, 0.0009, -2.4900, 4.8045",
        "50, -0.0010, 2.4900, 50, 0.0010, -2.4900, 4.8045",
        "50, -0.0010, 2.4900, 50, 0.0011, -2.4900, 4.7461",
        "50, 2.5, 0, 50, 0, -2.5, 4.3065",
        "50, 2.5, 0, 73, 25, -18, 27.1492",
        "50, 2.5, 0, 61, -5, 29, 22.8977",
        "50, 2.5, 0, 56, -27, -3, 31.9030",
        "50, 2.5, 0, 58, 24, 15, 19.4535",
        "50, 2.5, 0, 50, 3.1736, 0.5854, 1.0000",
        "50, 2.5, 0, 50, 3.2972, 0, 1.0000",
        "50, 2.5, 0, 50, 1.8634, 0.5757, 1.0000",
        "50, 2.5, 0, 50, 3.2592, 0.3350, 1.0000",
        "60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644",
        "63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.2630",
        "61.2901, 3.7196, -5.3901, 61.4292, 2.2480, -4.9620, 1.8731",
        "35.0831, -44.1164, 3.7933, 35.0232, -40.0716, 1.5901, 1.8645",
        "22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373",
        "36.4612, 47.8580, 18.3852, 36.2715, 50.5065, 21.2231, 1.4146",
        "90.8027, -2.0831, 1.4410, 91.1528, -1.6435, 0.0447, 1.4441",
        "90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381",
        "6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377",
        "2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514, 0.9082",
    })
    void pairsOfThePaperHaveItsDifferences(
            double l1, double a1, double b1, double l2, double a2, double b2, double expected) {
        CieLab first = new CieLab(l1, a1, b1);
        CieLab second = new CieLab(l2, a2, b2);
        assertThat(first.difference(second)).isCloseTo(expected, within(PUBLISHED_DIGITS));
        assertThat(second.difference(first)).isCloseTo(expected, within(PUBLISHED_DIGITS));
    }

    /** Y = ((L* + 16) / 116)^3 by definition. */
    @ParameterizedTest
    @ValueSource(doubles = {100, 50})
    void whiteOfD65IsWhiteAndGraysAreGray(double lightness) {
        double gray = Math.pow((lightness + 16) / 116, 3);
        CieLab color = CieLab.ofXyz(0.95047 * gray, gray, 1.08883 * gray);
        assertThat(color.lightness()).isCloseTo(lightness, within(1e-12));
        assertThat(color.chroma()).isCloseTo(0, within(1e-12));
    }
}
