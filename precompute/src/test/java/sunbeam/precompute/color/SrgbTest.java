package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class SrgbTest {

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
}
