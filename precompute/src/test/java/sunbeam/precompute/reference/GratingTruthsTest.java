package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.special.BesselJ;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;

/** Gratings whose orders are known in closed form: one period, 1 x N samples, seen through the coherence window; and a mirror. */
class GratingTruthsTest {
    // The reference's rounding is about 2e-15 / sqrt(power); powers here are above 1e-11.
    private static final double TRUTH = 1e-9;
    private static final double WAVELENGTH = 450e-9;
    private static final double PERIOD = 2.5e-6;
    private static final CoherenceWindow WINDOW = new CoherenceWindow(2.5e-6);

    /** Amplitude of an order as a function of the relief's phase k w h. */
    private interface Order {
        Complex amplitude(int order, double phase);
    }

    /** Both averages against sums of Gaussian orders, on and between the orders. */
    private static void assertOrders(HeightMap map, double relief, Order order) {
        ReferenceEvaluator reference = new ReferenceEvaluator(map, WINDOW, WindowOrigin.CORNER);
        for (double position = -4; position <= 4; position += 0.125) {
            DirectionPair pair =
                    DirectionPairs.seeing(10, position / PERIOD, 0.3 * WINDOW.sigmaFrequency(), WAVELENGTH);
            double phase = 2 * Math.PI / WAVELENGTH * pair.w() * relief;
            Complex amplitude = Complex.ZERO;
            double ensemble = 0;
            for (int m = -9; m <= 9; m++) {
                double distance = (position - m) / (PERIOD * WINDOW.sigmaFrequency());
                double gauss = Math.exp(-0.5 * (distance * distance + 0.3 * 0.3));
                Complex part = order.amplitude(m, phase).multiply(gauss);
                amplitude = amplitude.add(part);
                ensemble += Math.pow(part.abs(), 2);
            }
            ReferenceEvaluator.Power power = reference.powers(pair, WAVELENGTH);
            double coherent = Math.pow(amplitude.abs(), 2);
            assertThat(power.coherent()).as("coherent at %f", position).isCloseTo(coherent, within(TRUTH * coherent));
            assertThat(power.ensemble()).as("ensemble at %f", position).isCloseTo(ensemble, within(TRUTH * ensemble));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {20e-9, 100e-9, 250e-9})
    void sinusoidHasBesselOrders(double amplitude) {
        // exp(i z sin t) = sum J_m(z) e^(i m t), seen at f = -m / period. 64 samples a period fold J_55 and beyond onto
        // these orders: below 1e-25 at phases up to 7.
        HeightMap map = Surfaces.of(64, 1, PERIOD / 64, (x, y) -> amplitude * Math.sin(2 * Math.PI * x / PERIOD));
        assertOrders(map, amplitude, (order, phase) -> new Complex(bessel(-order, phase)));
    }

    private static double bessel(int order, double argument) {
        boolean odd = order % 2 != 0;
        double sign = odd && (order < 0) != (argument < 0) ? -1 : 1;
        return sign * BesselJ.value(Math.abs(order), Math.abs(argument));
    }

    @ParameterizedTest
    // Not half of the period, where even orders vanish.
    @ValueSource(ints = {20, 31, 51})
    void lamellarGratingHasItsClosedForm(int raised) {
        int samples = 64;
        double depth = 120e-9;
        HeightMap map = Surfaces.sampled(samples, 1, PERIOD / samples, (column, row) -> column < raised ? depth : 0);
        // Order m of a step of a samples in N is a Dirichlet kernel, with the phase of its middle (a - 1) / 2.
        assertOrders(map, depth, (order, phase) -> {
            Complex step = Complex.I.multiply(phase).exp().subtract(1);
            double angle = Math.PI * order / samples;
            Complex line = order == 0
                    ? new Complex((double) raised / samples)
                    : Complex.I
                            .multiply(angle * (raised - 1))
                            .exp()
                            .multiply(Math.sin(raised * angle) / (samples * Math.sin(angle)));
            return step.multiply(line).add(order == 0 ? 1 : 0);
        });
    }

    @Test
    void finelySampledRampHasSincSquaredOrders() {
        int samples = 4096;
        double height = 300e-9;
        HeightMap map = Surfaces.of(samples, 1, PERIOD / samples, (x, y) -> height * x / PERIOD);
        ReferenceEvaluator reference =
                new ReferenceEvaluator(map, new CoherenceWindow(4 * PERIOD), WindowOrigin.CENTRE);
        for (int m = -3; m <= 4; m++) {
            DirectionPair pair = DirectionPairs.seeing(10, m / PERIOD, 0, WAVELENGTH);
            // w is negative, so the bright order lies at positive u: light leaves towards -x (docs/conventions.md).
            double offset = Math.PI * (height * pair.w() / WAVELENGTH + m);
            double sincSquared = Math.pow(Math.sin(offset) / offset, 2);
            // Samples instead of a ramp: a Dirichlet kernel, larger by offset^2 / (3 samples^2).
            assertThat(reference.coherent(pair, WAVELENGTH))
                    .as("order %d", m)
                    .isCloseTo(sincSquared, within(sincSquared * offset * offset / ((double) samples * samples)));
        }
    }

    private static final double GREEN = 550e-9;
    private static final HeightMap FLAT = Surfaces.of(4, 3, 100e-9, (x, y) -> 1e-3);

    @ParameterizedTest
    @CsvSource({"1e-6", "65e-6", "1e-3"})
    void powerIsTheWindowsSpectrum(double coherenceLength) {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        ReferenceEvaluator reference = new ReferenceEvaluator(FLAT, window, WindowOrigin.CENTRE);
        for (double deviations = 0; deviations <= 2.5; deviations += 0.5) {
            double frequency = deviations * window.sigmaFrequency();
            DirectionPair pair = DirectionPairs.seeing(0, frequency, -0.5 * frequency, GREEN);
            double expected = Math.exp(-1.25 * deviations * deviations);
            ReferenceEvaluator.Power power = reference.powers(pair, GREEN);
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
        double width = GREEN * window.sigmaFrequency() / Math.pow(Math.cos(Math.toRadians(thetaDegrees)), 2);
        assertThat(reflected / reflectance).isCloseTo(1, within(20 * width * width));
    }

    /** The integral of brdf cos(theta_r) over the hemisphere: cos(theta_r) d omega = dx dy of the disc. */
    private static double hemisphericalReflectance(Direction light, CoherenceWindow window) {
        // Samples coarser than the wavelength suffice for a mirror near its specular direction.
        HeightMap coarse = Surfaces.of(1, 1, window.sigmaMeters() / 16, (x, y) -> 0);
        ReferenceEvaluator reference = new ReferenceEvaluator(coarse, window, WindowOrigin.CENTRE);
        // Trapezoid over a Gaussian of deviation sigma_f / sqrt(2): at a step of half of sigma_f its error is 1e-17.
        double step = 0.5 * window.sigmaFrequency() * GREEN;
        double sum = 0;
        for (int i = -12; i <= 12; i++) {
            for (int j = -12; j <= 12; j++) {
                DirectionPair pair =
                        new DirectionPair(light, Direction.ofDisc(-light.x() + i * step, -light.y() + j * step));
                sum += Gain.KERATIN.brdf(pair, window, GREEN) * reference.coherent(pair, GREEN);
            }
        }
        return sum * step * step;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 45, 89, 89.9})
    void isWhiteInSpecularDirection(double theta) {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);
        ReferenceEvaluator reference = new ReferenceEvaluator(FLAT, window, WindowOrigin.CENTRE);
        DirectionPair pair = new DirectionPair(Direction.ofDegrees(theta, 0), Direction.ofDegrees(theta, 180));
        assertThat(reference.powers(pair, 380e-9).coherent()).isCloseTo(1, within(1e-9));
        assertThat(reference.powers(pair, 780e-9).ensemble()).isCloseTo(1, within(1e-9));
    }

    /** The thesis has [0, 1]; 1 is a mirror along the normal, and a mirror near the horizon is brighter. */
    @Test
    void theRelativeRadianceOfAMirrorIsNoShareOfTheLight() {
        DirectionPair mirror = new DirectionPair(Direction.ofDegrees(85, 0), Direction.ofDegrees(85, 180));

        // R(85) / R(0) = 1 + 24 (1 - cos 85)^5 = 16.22; (1 + cos 170)^2 / (4 cos(85)^3) = 0.0872 = cos 85; the mask is
        // 1.
        double expected = (1 + 24 * Math.pow(1 - Math.cos(Math.toRadians(85)), 5)) * Math.cos(Math.toRadians(85));
        assertThat(Gain.relativeRadiance(mirror))
                .isCloseTo(expected, within(1e-9))
                .isCloseTo(1.41, within(0.05));
    }
}
