package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;

/** A flat mirror shows the coherence window alone. */
class MirrorTruthsTest {
    private static final double WAVELENGTH = 550e-9;
    private static final HeightMap FLAT = Surfaces.of(4, 3, 100e-9, (x, y) -> 1e-3);

    @ParameterizedTest
    @CsvSource({"1e-6", "65e-6", "1e-3"})
    void powerIsTheWindowsSpectrum(double coherenceLength) {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        ReferenceEvaluator reference = new ReferenceEvaluator(FLAT, window, WindowOrigin.CENTRE);
        for (double deviations = 0; deviations <= 2.5; deviations += 0.5) {
            double frequency = deviations * window.sigmaFrequency();
            DirectionPair pair = DirectionPairs.seeing(0, frequency, -0.5 * frequency, WAVELENGTH);
            double expected = Math.exp(-1.25 * deviations * deviations);
            ReferenceEvaluator.Power power = reference.powers(pair, WAVELENGTH);
            assertThat(power.coherent()).isCloseTo(expected, within(1e-9 * expected));
            assertThat(power.ensemble()).isCloseTo(expected, within(1e-9 * expected));
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 650e-6", "30, 650e-6", "60, 650e-6", "60, 65e-6", "75, 650e-6"})
    void reflectsExactlyItsReflectance(double thetaDegrees, double coherenceLength) {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        double reflected = hemisphericalReflectance(Direction.ofDegrees(thetaDegrees, 40), window);
        double reflectance = Gain.reflectance(Math.cos(Math.toRadians(thetaDegrees)));
        // The peak has an angular deviation of lambda sigma_f / cos(theta); factors vary over it in second order.
        double width = WAVELENGTH * window.sigmaFrequency() / Math.pow(Math.cos(Math.toRadians(thetaDegrees)), 2);
        assertThat(reflected / reflectance).isCloseTo(1, within(20 * width * width));
    }

    /** The integral of brdf cos(theta_r) over the hemisphere: cos(theta_r) d omega = dx dy of the disc. */
    private static double hemisphericalReflectance(Direction light, CoherenceWindow window) {
        // Samples coarser than the wavelength suffice for a mirror near its specular direction.
        HeightMap coarse = Surfaces.of(1, 1, window.sigmaMeters() / 16, (x, y) -> 0);
        ReferenceEvaluator reference = new ReferenceEvaluator(coarse, window, WindowOrigin.CENTRE);
        // Trapezoid over a Gaussian of deviation sigma_f / sqrt(2): at a step of half of sigma_f its error is 1e-17.
        double step = 0.5 * window.sigmaFrequency() * WAVELENGTH;
        double sum = 0;
        for (int i = -12; i <= 12; i++) {
            for (int j = -12; j <= 12; j++) {
                DirectionPair pair =
                        new DirectionPair(light, Direction.ofDisc(-light.x() + i * step, -light.y() + j * step));
                sum += Gain.brdf(pair, window, WAVELENGTH) * reference.coherent(pair, WAVELENGTH);
            }
        }
        return sum * step * step;
    }

    @Test
    void isWhiteInSpecularDirection() {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);
        ReferenceEvaluator reference = new ReferenceEvaluator(FLAT, window, WindowOrigin.CENTRE);
        for (double theta : new double[] {0, 45, 89, 89.9}) {
            DirectionPair pair = new DirectionPair(Direction.ofDegrees(theta, 0), Direction.ofDegrees(theta, 180));
            assertThat(reference.powers(pair, 380e-9).coherent()).isCloseTo(1, within(1e-9));
            assertThat(reference.powers(pair, 780e-9).ensemble()).isCloseTo(1, within(1e-9));
        }
    }
}
