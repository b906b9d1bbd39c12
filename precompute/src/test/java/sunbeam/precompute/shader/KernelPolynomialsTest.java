package sunbeam.precompute.shader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.spectrum.InterpolationDesign;

class KernelPolynomialsTest {
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9, 10})
    void weightsAreTheKernelsEverywhere(int taps) {
        InterpolationDesign design = InterpolationDesign.best(2.5, taps, 3.5);
        KernelPolynomials polynomials = KernelPolynomials.of(taps, design::kernel);
        Random random = new Random(taps);
        for (int i = 0; i < 1000; i++) {
            double fraction = random.nextDouble();
            for (int tap = 0; tap < taps; tap++) {
                double distance = fraction + 0.5 * taps - 1 - tap;
                // Polynomials may omit 2e-9 of the peak, 1; they are fitted at 64 places a tap.
                assertEquals(design.kernel(distance), polynomials.weight(tap, 2 * fraction - 1), 2.5e-9);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 5, 8, 10})
    void float32RoundsThemInProportionToEachTapsOwnWeights(int taps) {
        InterpolationDesign design = InterpolationDesign.best(2.5, taps, 3.5);
        KernelPolynomials polynomials = KernelPolynomials.of(taps, design::kernel);
        for (int tap = 0; tap < taps; tap++) {
            double largest = Math.max(polynomials.weight(tap, -1), polynomials.weight(tap, 1));
            for (int i = -20; i <= 20; i++) {
                float place = i / 20f;
                // Horner's rule in float32, one rounding of 6e-8 for each of the few relevant steps.
                double error = Math.abs(inFloats(polynomials, tap, place) - polynomials.weight(tap, place));
                assertTrue(error <= 4e-7 * Math.max(largest, polynomials.weight(tap, place)), tap + " " + place);
            }
        }
    }

    private static float inFloats(KernelPolynomials polynomials, int tap, float place) {
        float sum = 0;
        for (int power = polynomials.powers() - 1; power >= 0; power--) {
            sum = sum * place + (float) polynomials.coefficients()[tap][power];
        }
        return sum;
    }

    @Test
    void aKernelWithACornerIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> KernelPolynomials.of(4, x -> Math.abs(x - 0.3)));
    }
}
