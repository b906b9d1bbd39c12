package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.reference.ExactLight.ReplicaLight;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;
import sunbeam.precompute.reference.SurfaceSums.UnitCircle;

/** Symmetries of the reference, and its ensemble average as a mean over positions of the window. */
class ReferenceEvaluatorTest {
    private static final double WAVELENGTH = 500e-9;

    private final SplittableRandom random = new SplittableRandom(5);

    /** Windows smaller and larger than the patch, the latter with folded replicas. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 3e-6, 12e-6})
    void aSampleHasTheCoherentPower(double coherenceLength) {
        HeightMap map = Surfaces.random(33, 20, 80e-9, 400e-9, 3).map(height -> height + 1e-3);
        DirectionPair pair = new DirectionPair(Direction.ofDegrees(20, 30), Direction.ofDegrees(50, 200));
        for (WindowOrigin origin : WindowOrigin.values()) {
            ReferenceEvaluator reference =
                    new ReferenceEvaluator(map, CoherenceWindow.ofCoherenceLength(coherenceLength), origin);
            double exact = reference.powers(pair, WAVELENGTH).coherent();
            // An offset of 1 mm rounds heights to 1e-19 m, 3e-12 of a wavelength.
            assertThat(reference.sample(pair, WAVELENGTH).coherent())
                    .isCloseTo(exact, within(1e-10 * Math.sqrt(exact)));
        }
    }

    @Test
    void theSpecularShareIsThatOfTheMeanPhase() {
        // Two heights a quarter wavelength apart under normal light cancel.
        HeightMap map = Surfaces.of(8, 8, 80e-9, (x, y) -> Math.round(x / 80e-9) % 2 * WAVELENGTH / 4);
        ReferenceEvaluator reference =
                new ReferenceEvaluator(map, CoherenceWindow.ofCoherenceLength(1e-6), WindowOrigin.CENTRE);
        DirectionPair normal = new DirectionPair(new Direction(0, 0, 1), new Direction(0, 0, 1));
        assertThat(reference.sample(normal, WAVELENGTH).specular()).isLessThan(1e-28);
        assertThat(reference.sample(normal, WAVELENGTH / 2).specular()).isCloseTo(1, within(1e-14));
    }

    private static final CoherenceWindow WINDOW = new CoherenceWindow(1e-6);
    private static final HeightMap SURFACE = Surfaces.random(14, 9, 90e-9, 500e-9, 11);

    private final ReferenceEvaluator reference = new ReferenceEvaluator(SURFACE, WINDOW, WindowOrigin.CENTRE);

    @Test
    void powersStayWhenLightAndViewChangePlacesUvwItsSignOrHeightsTheirOffset() {
        // Heights at a millimeter have a rounding of 1e-19 m: phases move by 2 pi 1e-19 / lambda.
        ReferenceEvaluator raised =
                new ReferenceEvaluator(SURFACE.map(height -> height + 1e-3), WINDOW, WindowOrigin.CENTRE);
        for (int i = 0; i < 50; i++) {
            DirectionPair there = DirectionPairs.random(random);
            DirectionPair back = new DirectionPair(there.wr(), there.wi());
            double wavelength = 380e-9 + 400e-9 * random.nextDouble();
            double brdf = Gain.KERATIN.brdf(there, WINDOW, wavelength);
            assertThat(Gain.KERATIN.brdf(back, WINDOW, wavelength)).isCloseTo(brdf, within(1e-9 * brdf));
            Power power = reference.powers(there, wavelength);
            assertSame(power, reference.powers(back, wavelength));
            assertSame(power, reference.powers(DirectionPairs.of(-there.u(), -there.v(), -there.w()), wavelength));
            assertSame(power, raised.powers(there, wavelength));
        }
    }

    private static void assertSame(Power a, Power b) {
        // Powers of this surface are above 1e-5: its rounding is 1e-12 of them.
        assertThat(b.coherent()).isCloseTo(a.coherent(), within(1e-9 * a.coherent() + 1e-15));
        assertThat(b.ensemble()).isCloseTo(a.ensemble(), within(1e-9 * a.ensemble() + 1e-15));
    }

    /** |sum g(x - center) p exp(2 pi i f x)|^2 over all samples of the periodic patch, by the square of the window's integral. */
    private static double windowedAt(HeightMap map, double sigma, double cx, double cy, DirectionPair pair) {
        double real = 0;
        double imaginary = 0;
        double pitch = map.pitchX();
        int reach = (int) Math.ceil(9 * sigma / pitch) + 1;
        for (int i = (int) (cx / pitch) - reach; i <= cx / pitch + reach; i++) {
            for (int j = (int) (cy / pitch) - reach; j <= cy / pitch + reach; j++) {
                double x = i * pitch;
                double y = j * pitch;
                double gauss = Math.exp(-0.5 * (Math.pow(x - cx, 2) + Math.pow(y - cy, 2)) / (sigma * sigma));
                // Rows run downwards.
                double height = map.at(Math.floorMod(i, map.columns()), Math.floorMod(-j, map.rows()));
                double phase = 2 * Math.PI / WAVELENGTH * (pair.w() * height + pair.u() * x + pair.v() * y);
                real += gauss * Math.cos(phase);
                imaginary += gauss * Math.sin(phase);
            }
        }
        double integral = 2 * Math.PI * Math.pow(sigma / pitch, 2);
        return (real * real + imaginary * imaginary) / (integral * integral);
    }

    /** A window of 2.8 samples: with positions between samples the definition is exact. */
    @Test
    void theEnsembleOfACoarseWindowIsTheMeanOverPositionsBetweenTheSamplesToo() {
        double pitch = 350e-9;
        HeightMap map = Surfaces.random(5, 4, pitch, 300e-9, 9);
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(2.8 * pitch);
        // A trigonometric polynomial over the period; the window's spectrum is negligible at 8 steps a sample.
        int perSample = 8;
        double largest = 0;
        for (int n = 0; n < 4; n++) {
            DirectionPair pair = DirectionPairs.random(random);
            double all = 0;
            double onSamples = 0;
            for (int i = 0; i < 5 * perSample; i++) {
                for (int j = 0; j < 4 * perSample; j++) {
                    double power =
                            windowedAt(map, window.sigmaMeters(), i * pitch / perSample, j * pitch / perSample, pair);
                    all += power / (20 * perSample * perSample);
                    onSamples += i % perSample == 0 && j % perSample == 0 ? power / 20 : 0;
                }
            }
            double expected = new ReferenceEvaluator(map, window, WindowOrigin.CENTRE)
                    .powers(pair, WAVELENGTH)
                    .ensemble();
            assertThat(all).isCloseTo(expected, within(1e-9 * expected));
            largest = Math.max(largest, Math.abs(onSamples / expected - 1));
        }
        // Over positions at samples alone it is another mean.
        assertThat(largest).isGreaterThan(1e-3);
    }

    // Rounding of a thousand terms.
    private static final double ROUNDING = 1e-12;

    private static ReplicaLight light(HeightMap map, int alongX, int alongY) {
        return new ReplicaLight(map, new Replicas(alongX, alongY), CieTable.load());
    }

    @Test
    void aFlatSquareIsTheDiffractionOfItsAperture() {
        HeightMap flat = Surfaces.of(10, 8, 100e-9, (x, y) -> 0);
        double alongX = dirichlet(0.13 / WAVELENGTH * 100e-9, 30);
        double alongY = dirichlet(-0.21 / WAVELENGTH * 100e-9, 16);
        assertThat(light(flat, 3, 2).power(DirectionPairs.of(0.13, -0.21, -1.5), WAVELENGTH))
                .isCloseTo(Math.pow(alongX * alongY, 2), within(ROUNDING));
    }

    private static double dirichlet(double turns, int count) {
        return Math.sin(Math.PI * turns * count) / (count * Math.sin(Math.PI * turns));
    }

    @Test
    void replicasAreOnePeriodTimesTheArrayFactor() {
        HeightMap map = Surfaces.random(12, 9, 90e-9, 200e-9, 3);
        DirectionPair pair = DirectionPairs.of(0.37, 0.22, -1.7);
        double one = light(map, 1, 1).power(pair, WAVELENGTH);
        double many = light(map, 5, 4).power(pair, WAVELENGTH);
        double arrayX = dirichlet(0.37 / WAVELENGTH * map.width(), 5);
        double arrayY = dirichlet(0.22 / WAVELENGTH * map.height(), 4);
        assertThat(many).isCloseTo(one * Math.pow(arrayX * arrayY, 2), within(ROUNDING));
    }

    @Test
    void anOrderHasThePowerOfTheGaussianWindow() {
        // On a bin the Gaussian window and the sharp edge give the same order; neighbors are 40 deviations away.
        CoherenceWindow wide = new CoherenceWindow(7e-6);
        HeightMap grid = Surfaces.random(12, 12, 90e-9, 200e-9, 3);
        DirectionPair onBin = DirectionPairs.of(2 * WAVELENGTH / grid.width(), WAVELENGTH / grid.height(), -1.2);
        assertThat(new ReferenceEvaluator(grid, wide, WindowOrigin.CENTRE).coherent(onBin, WAVELENGTH))
                .isCloseTo(light(grid, 1, 1).power(onBin, WAVELENGTH), within(1e-9));
    }

    @Test
    void replicasFillTheCoherenceLength() {
        CoherenceWindow sunlight = CoherenceWindow.ofCoherenceLength(65e-6);
        assertThat(Replicas.filling(sunlight, 2.5e-6, 2.5e-6)).isEqualTo(new Replicas(26, 26));
        assertThat(Replicas.filling(sunlight, 65e-6, 25e-9)).isEqualTo(new Replicas(1, 2600));
        assertThat(Replicas.filling(sunlight, 1e-3, 1e-3)).isEqualTo(new Replicas(1, 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-3, 4, 100, 1e6})
    void theUnitCircleIsThatOfTheLibrary(double largest) {
        double[] angles =
                new SplittableRandom(7).doubles(1000, -largest, largest).toArray();
        double[] sines = angles.clone();
        double[] cosines = new double[angles.length];
        UnitCircle.points(sines, cosines);
        // A few units in the last place.
        double rounding = 4e-16 * Math.max(4, largest);
        for (int i = 0; i < angles.length; i++) {
            assertThat(cosines[i]).isCloseTo(Math.cos(angles[i]), within(rounding));
            assertThat(sines[i]).isCloseTo(Math.sin(angles[i]), within(rounding));
        }
    }
}
