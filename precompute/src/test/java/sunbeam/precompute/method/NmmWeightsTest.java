package sunbeam.precompute.method;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.CieTable;

class NmmWeightsTest {
    private final CieTable cie = CieTable.load();

    @Test
    void aNarrowOrderHasTheWidthOfItsGaussianInWavelength() {
        double wavelength = 550.5e-9;
        double width = 1e3;
        double[] weight = NmmMethod.weight(cie, 1 / wavelength, width);
        double expected =
                Math.sqrt(Math.PI) * wavelength * wavelength * width * cie.at(wavelength, 1) / cie.integralOfY();
        // 0.3 nm wide: S ybar is a straight line there, and lambda^2 bends by 1e-6.
        assertThat(weight[1]).isCloseTo(expected, within(1e-5 * expected));
    }

    @Test
    void ordersThatTileTheBandAddUpToWhite() {
        double[] sum = new double[3];
        double width = 2e4;
        double step = width / 2;
        for (double place = 1e6; place < 3e6; place += step) {
            double[] piece = NmmMethod.weight(cie, place, width);
            for (int c = 0; c < 3; c++) {
                sum[c] += piece[c] * step / (Math.sqrt(Math.PI) * width);
            }
        }
        // Gaussians half a width apart add up to 1 within 2 exp(-(pi / 0.5)^2) = 1e-17; the rest is that a quarter of a
        // width, 1 to 3 nm, steps across the corners of the 1 nm table.
        assertThat(sum[1]).isCloseTo(1, within(1e-3));
    }
}
