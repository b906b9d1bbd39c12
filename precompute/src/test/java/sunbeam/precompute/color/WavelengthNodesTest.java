package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WavelengthNodesTest {
    private static final CieTable CIE = CieTable.load();
    private static final double SIGMA_FREQUENCY = 9794;

    /** 40 points on each of 16 parts of every nanometer of the tables, which are linear between their values. */
    private static double[] gaussLegendre(DoubleUnaryOperator power) {
        GaussIntegrator rule = new GaussIntegratorFactory().legendre(40);
        double[] xyz = new double[3];
        double part = 1e-9 / 16;
        for (int i = 0; i < 400 * 16; i++) {
            for (int g = 0; g < 40; g++) {
                double wavelength = CieTable.MINIMUM_WAVELENGTH + part * (i + 0.5 + 0.5 * rule.getPoint(g));
                double weight = 0.5 * part * rule.getWeight(g) / CIE.integralOfY();
                for (int c = 0; c < 3; c++) {
                    xyz[c] += weight * power.applyAsDouble(wavelength) * CIE.at(wavelength, c);
                }
            }
        }
        return xyz;
    }

    @Test
    void constantPowerIsWhiteHoweverFewTheNodes() {
        double[] xyz = WavelengthNodes.integrated(CIE, 1e9).sum(wavelength -> 1);
        // Polynomials of degree 0 are exact; the rest is rounding.
        assertThat(xyz).containsExactly(gaussLegendre(wavelength -> 1), within(1e-12));
    }

    /** Orders from 1 to 400 nm wide: within the band and beyond its ends, and on the flanks of the color matching functions. */
    @ParameterizedTest
    @CsvSource({
        "1.9, 381.3e-9",
        "1.9, 378.5e-9",
        "1.2, 412.3e-9",
        "1.2, 555.55e-9",
        "1, 781e-9",
        "0.8, 779e-9",
        "0.3, 395e-9",
        "0.3, 717e-9",
        "0.1, 450.5e-9",
        "0.02, 503.2e-9"
    })
    void ordersHaveTheirColor(double uv, double middle) {
        double deviation = SIGMA_FREQUENCY / (Math.sqrt(2) * uv);
        DoubleUnaryOperator order =
                wavelength -> Math.exp(-0.5 * Math.pow((1 / wavelength - 1 / middle) / deviation, 2));
        double[] expected = gaussLegendre(order);
        double largest = Math.max(expected[0], Math.max(expected[1], expected[2]));
        // The reference's step.
        double step = 1 / (1 / (0.7 * deviation) + 1 / 12e3);
        // Error of polynomials of degree 11: 5e-7 in the worst of 200 orders; relatively more of the little light that
        // the band leaves of an order beyond its ends.
        assertThat(WavelengthNodes.integrated(CIE, step).sum(order))
                .containsExactly(expected, within(2e-6 * Math.max(1e-4, largest)));
        // The reference's accuracy; sampling in steps of 0.5 nm erred by 1e-3 here.
        assertThat(WavelengthNodes.exact(CIE, order, step)).containsExactly(expected, within(1e-9 * largest));
    }
}
