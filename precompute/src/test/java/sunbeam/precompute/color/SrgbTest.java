package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class SrgbTest {
    @Test
    void channelsComeBackFromLinearLight() {
        for (int channel = 0; channel <= 255; channel++) {
            assertThat(Srgb.channel(Srgb.linear(channel))).isEqualTo(channel);
        }
    }

    @Test
    void theCurveIsTheStandards() {
        // IEC 61966-2-1: linear 0.2140 is encoded 0.5, between channels 127 and 128; the pieces meet at 0.0031308.
        assertThat(Srgb.linear(127)).isLessThan(0.21404114);
        assertThat(Srgb.linear(128)).isGreaterThan(0.21404114);
        assertThat(Srgb.linear(10)).isCloseTo(10 / 255.0 / 12.92, within(1e-15));
        // Channel 11, encoded 0.0431, lies on the power; the straight line would be 1e-5 off.
        assertThat(Srgb.linear(11)).isCloseTo(Math.pow((11 / 255.0 + 0.055) / 1.055, 2.4), within(1e-15));
        assertThat(Srgb.linear(255)).isEqualTo(1);
    }

    @Test
    void channelsAreRoundedToTheNearest() {
        for (double linear = 0; linear <= 1; linear += 1.7e-4) {
            double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
            assertThat(Srgb.channel(linear)).isEqualTo((int) Math.round(255 * encoded));
        }
    }

    @Test
    void lightBeyondTheDisplayIsClipped() {
        assertThat(Srgb.channel(-3)).isZero();
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

    @Test
    void aColourOfADiagramKeepsItsHueHoweverBrightItIs() {
        double[] orange = Srgb.xyz(0.5, 0.2, 0.01);
        DisplayColor.Hued shown = DisplayColor.Hued.of(orange);
        assertThat(shown.rgb())
                .as("what fits is what maps show")
                .isEqualTo(new DisplayTransform(1, Tone.COMPRESS).rgb(orange));
        assertThat(shown.tooBright() || shown.tooPure()).isFalse();
        double[] bright = {1000 * orange[0], 1000 * orange[1], 1000 * orange[2]};
        assertThat(DisplayColor.Hued.of(bright).tooBright()).isTrue();
        for (double[] same : new double[][] {orange, bright}) {
            DisplayColor.Hued brightest = DisplayColor.Hued.brightest(same);
            assertThat(brightest.rgb()).isEqualTo(DisplayColor.Hued.of(bright).rgb());
            assertThat(brightest.rgb() >> 16).as("red is full").isEqualTo(255);
            assertThat(brightest.rgb() >> 8 & 255).isEqualTo(Srgb.channel(0.4));
        }
        // Spectral green, x = 0.07, y = 0.83, is outside: without red it is as near as a screen comes along its hue.
        DisplayColor.Hued green = DisplayColor.Hued.of(new double[] {0.03, 0.3, 0.03});
        assertThat(green.tooPure()).isTrue();
        assertThat(green.rgb() >> 16).isZero();
        assertThat(DisplayColor.Hued.of(new double[] {Double.NaN, Double.NaN, Double.NaN})
                        .rgb())
                .isZero();
    }
}
