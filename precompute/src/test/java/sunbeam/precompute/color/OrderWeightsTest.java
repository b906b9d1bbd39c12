package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class OrderWeightsTest {
    private final CieTable cie = CieTable.load();

    @Test
    void aNarrowOrderHasTheWidthOfItsGaussianInWavelength() {
        double wavelength = 550.5e-9;
        double width = 1e3;
        double[] weight = OrderWeights.integral(cie, 1 / wavelength, width);
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
            double[] piece = OrderWeights.integral(cie, place, width);
            for (int c = 0; c < 3; c++) {
                sum[c] += piece[c] * step / (Math.sqrt(Math.PI) * width);
            }
        }
        // Gaussians half a width apart add up to 1 within 2 exp(-(pi / 0.5)^2) = 1e-17; the rest is that a quarter of a
        // width, 1 to 3 nm, steps across the corners of the 1 nm table.
        assertThat(sum[1]).isCloseTo(1, within(1e-3));
    }

    @Test
    void tablesHoldTheTabulatedFunction() {
        OrderWeights table = OrderWeights.tabulate(cie, 5e3, 7e4);
        int row = 7;
        int column = 400;
        double width = 5e3 + (7e4 - 5e3) * row / (OrderWeights.ROWS - 1);
        double place = table.minimumPlace()
                + (table.maximumPlace() - table.minimumPlace()) * column / (OrderWeights.COLUMNS - 1);
        double[] weight = OrderWeights.integral(cie, place, width);
        for (int c = 0; c < 3; c++) {
            float stored = table.values()[3 * (row * OrderWeights.COLUMNS + column) + c];
            // float32
            assertThat(stored * width).isCloseTo(weight[c], within(1e-6 * weight[c]));
        }
    }

    @Test
    void theTablesBorderIsBlack() {
        OrderWeights table = OrderWeights.tabulate(cie, 5e3, 7e4);
        for (int row = 0; row < OrderWeights.ROWS; row++) {
            // A millionth of the largest, 4e-13 meters.
            assertThat(table.values()[3 * row * OrderWeights.COLUMNS + 1]).isLessThan(4e-19f);
            assertThat(table.values()[3 * ((row + 1) * OrderWeights.COLUMNS - 1) + 1])
                    .isLessThan(4e-19f);
        }
    }
}
