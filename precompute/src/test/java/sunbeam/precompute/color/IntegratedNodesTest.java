package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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
        // Polynomials of degree 0 are exact; what is left is the rounding of 400,000 summands.
        assertThat(xyz).containsExactly(exact, within(1e-10));
    }

    /** An order of one nanometre sampled every 0.7 deviations, as the reference does it. */
    @ParameterizedTest
    @ValueSource(doubles = {395e-9, 412.3e-9, 450.5e-9, 555e-9, 612.7e-9, 700e-9})
    void narrowOrdersAnywhereHaveTheirExactColour(double middle) {
        double deviation = 1e-9 / (middle * middle);
        DoubleUnaryOperator order =
                wavelength -> Math.exp(-0.5 * Math.pow((1 / wavelength - 1 / middle) / deviation, 2));
        double[] exact = bruteForce(order);
        double[] xyz = sum(IntegratedNodes.of(CIE, 0.7 * deviation), order);
        double largest = Math.max(exact[0], Math.max(exact[1], exact[2]));
        // D65's kinks every 5 nm leave 1e-6; the trapezoid rule in steps of 1 nm is off by up to 1e-3 here.
        assertThat(xyz).containsExactly(exact, within(1e-5 * largest));
    }
}
