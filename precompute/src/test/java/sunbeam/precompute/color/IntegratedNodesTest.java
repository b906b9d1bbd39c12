package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class IntegratedNodesTest {
    private static final CieTable CIE = CieTable.load();

    private static double[] sum(WavelengthNodes nodes, DoubleUnaryOperator power) {
        double[] xyz = new double[3];
        for (int i = 0; i < nodes.count(); i++) {
            for (int c = 0; c < 3; c++) {
                xyz[c] += nodes.weights()[i][c] * power.applyAsDouble(nodes.wavelengths()[i]);
            }
        }
        return xyz;
    }

    /** Midpoint rule in steps of 1 pm: no kink of the table lies within a step. */
    private static double[] bruteForce(DoubleUnaryOperator power) {
        double[] xyz = new double[3];
        int steps = 400_000;
        for (int i = 0; i < steps; i++) {
            double wavelength = CieTable.MINIMUM_WAVELENGTH + (i + 0.5) * 1e-12;
            double value = power.applyAsDouble(wavelength) * 1e-12 / CIE.integralOfY();
            for (int c = 0; c < 3; c++) {
                xyz[c] += value * CIE.at(wavelength, c);
            }
        }
        return xyz;
    }

    @Test
    void constantPowerIsWhiteHoweverFewTheNodes() {
        double[] exact = bruteForce(wavelength -> 1);
        double[] xyz = sum(IntegratedNodes.of(CIE, 1e9), wavelength -> 1);
        // Polynomials of degree 0 are exact; the rest is rounding of 400,000 summands.
        assertThat(xyz).containsExactly(exact, within(1e-10));
    }

    /** Orders from 1 to 25 nm wide, also where the color matching functions fall steeply and at the band's end. */
    @ParameterizedTest
    @CsvSource({
        "1.2, 412.3e-9",
        "1.2, 555e-9",
        "1.2, 700e-9",
        "0.8, 381e-9",
        "0.8, 779e-9",
        "0.3, 395e-9",
        "0.3, 717e-9",
        "0.1, 450.5e-9"
    })
    void ordersOfAnyWidthHaveTheirExactColor(double uv, double middle) {
        double deviation = 9794 / (Math.sqrt(2) * uv);
        DoubleUnaryOperator order =
                wavelength -> Math.exp(-0.5 * Math.pow((1 / wavelength - 1 / middle) / deviation, 2));
        double[] exact = bruteForce(order);
        // The steps of the reference (ReferenceColor).
        double[] xyz = sum(IntegratedNodes.of(CIE, 1 / (1 / (0.7 * deviation) + 1 / 12e3)), order);
        double largest = Math.max(exact[0], Math.max(exact[1], exact[2]));
        // Error of polynomials of degree 11: 5e-7 in the worst of 200 orders; the brute-force sum has 1e-7.
        assertThat(xyz).containsExactly(exact, within(2e-6 * largest));
    }
}
