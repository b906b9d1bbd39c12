package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.gpu.Comparison.TOLERANCE;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleBiFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;

/** Method {@code full} on the GPU: closed forms of gratings, laws of all surfaces, and directions at the ends of their ranges. */
class FullOnGpuTest extends InAContext {
    private static final double PERIOD = 2.5e-6;
    // Ten periods: an order's neighbor is exp(-0.5 (1 / 0.064)^2) of it, nothing.
    private static final double WINDOW = 10 * PERIOD;

    /** Middles of the orders -3 to 3 at five wavelengths. */
    private static List<Query> orders() {
        List<Query> queries = new ArrayList<>();
        for (double wavelength = 380e-9; wavelength < 781e-9; wavelength += 100e-9) {
            for (int m = -3; m <= 3; m++) {
                queries.add(Comparison.seeing(4, m / PERIOD, 0, wavelength));
            }
        }
        return queries;
    }

    /** @param power of an order, from its number and w / lambda */
    private static void assertOrders(HeightMap map, ToDoubleBiFunction<Integer, Double> power) {
        List<Query> queries = orders();
        List<float[]> computed = new Comparison(context, map, WINDOW).spectral(queries);
        Comparison.assertWithin(TOLERANCE, queries.size(), i -> {
            Query query = queries.get(i);
            double exact = power.applyAsDouble(i % 7 - 3, query.pair().w() / query.wavelength());
            return Math.abs(computed.get(i)[0] - exact) / exact;
        });
    }

    @ParameterizedTest
    // Not half of the period: even orders would vanish.
    @ValueSource(ints = {20, 31})
    void lamellarGratingHasItsClosedForm(int raised) {
        int samples = 64;
        double depth = 120e-9;
        HeightMap map = Comparison.heights(
                samples, 1, PERIOD / samples, (x, y) -> x < (raised - 0.5) * PERIOD / samples ? depth : 0);

        assertOrders(map, (order, wPerWavelength) -> {
            // 1 + (e^(i phase) - 1) share for order 0; elsewhere the step's height times a Dirichlet kernel.
            double phase = 2 * Math.PI * wPerWavelength * depth;
            double share = (double) raised / samples;
            double step = 4 * Math.pow(Math.sin(phase / 2), 2);
            double angle = Math.PI * order / samples;
            return order == 0
                    ? 1 - share * (1 - share) * step
                    : step * Math.pow(Math.sin(raised * angle) / (samples * Math.sin(angle)), 2);
        });
    }

    @ParameterizedTest
    @ValueSource(doubles = {100e-9, 250e-9})
    void rampHasSincSquaredOrders(double height) {
        // Samples instead of a slope: a Dirichlet kernel, larger by offset^2 / (3 samples^2), 4e-5 at most here.
        int samples = 1024;
        HeightMap map = Comparison.heights(samples, 1, PERIOD / samples, (x, y) -> height * x / PERIOD);

        assertOrders(map, (order, wPerWavelength) -> {
            // w is negative, so the bright order lies at positive u: the light leaves towards -x (docs/conventions.md).
            double offset = Math.PI * (height * wPerWavelength + order);
            return Math.pow(Math.sin(offset) / offset, 2);
        });
    }

    private static final HeightMap ROUGH = Comparison.noise(64, 64, 400e-9, 51);

    private static Comparison comparison(double coherenceLength) {
        return new Comparison(context, ROUGH, coherenceLength);
    }

    /** Coherence lengths that lead to a grid, to rays and to single orders. */
    @ParameterizedTest
    @ValueSource(doubles = {3e-6, 10e-6, 65e-6})
    void exactlySpecular(double coherenceLength) {
        List<Query> queries = new ArrayList<>();
        for (double theta = 0; theta <= 85; theta += 5) {
            DirectionPair pair = new DirectionPair(Direction.ofDegrees(theta, 30), Direction.ofDegrees(theta, 210));
            queries.add(new Query(pair, 500e-9));
        }
        Comparison comparison = comparison(coherenceLength);

        comparison.assertPowers(queries, TOLERANCE);
        comparison.assertColors(queries, TOLERANCE);
    }

    /** Light and view that nearly cancel: factors of 1 + wi . wr lost all digits but one at 89.9 degrees. */
    @Test
    void grazingMirrorsHaveTheirRadianceToo() {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(3e-6);
        List<Query> queries = new ArrayList<>();
        for (double theta : new double[] {89.5, 89.9, 89.99}) {
            queries.add(new Query(
                    new DirectionPair(Direction.ofDegrees(theta, 20), Direction.ofDegrees(theta, 200.01)), 500e-9));
        }
        List<float[]> computed = comparison(3e-6).spectral(queries);
        for (int i = 0; i < queries.size(); i++) {
            DirectionPair pair = queries.get(i).pair();
            float power = computed.get(i)[0];
            // Components near 1 are rounded by 6e-8, of a sum of 3.9e-4 at 89.99 degrees: 1.5e-4, and its square.
            assertThat(computed.get(i)[2] / power / Gain.relativeRadiance(pair))
                    .as("rho at %s", pair)
                    .isCloseTo(1, within(3e-4));
            assertThat(computed.get(i)[3] / power / Gain.brdf(pair, window, 500e-9))
                    .as("brdf at %s", pair)
                    .isCloseTo(1, within(3e-4));
        }
    }

    @Test
    void grazingLightAndViewStayFinite() {
        double coherenceLength = 3e-6;
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(coherenceLength);
        List<Query> queries = new ArrayList<>();
        for (double phi = 0; phi < 360; phi += 15) {
            // cos(89.9 degrees) = 1.7e-3, |w| = 3.5e-3; and one of both grazing only.
            queries.add(new Query(
                    new DirectionPair(Direction.ofDegrees(89.9, phi), Direction.ofDegrees(89.9, 100)), 450e-9));
            queries.add(
                    new Query(new DirectionPair(Direction.ofDegrees(89.9, phi), Direction.ofDegrees(20, 100)), 450e-9));
            queries.add(
                    new Query(new DirectionPair(Direction.ofDegrees(30, phi), Direction.ofDegrees(89.9, 100)), 450e-9));
        }
        Comparison comparison = comparison(coherenceLength);

        List<float[]> computed = comparison.spectral(queries);

        for (int i = 0; i < queries.size(); i++) {
            float[] result = computed.get(i);
            DirectionPair pair = queries.get(i).pair();
            // The factors are sums and cosines of float32 directions: 89.9 degrees has a cosine right to 4e-5, squared.
            double rho = Gain.relativeRadiance(pair) * result[0];
            double brdf = Gain.brdf(pair, window, 450e-9) * result[0];
            assertThat((double) result[2]).as("rho %d", i).isCloseTo(rho, within(TOLERANCE * rho));
            assertThat((double) result[3]).as("brdf %d", i).isCloseTo(brdf, within(TOLERANCE * brdf));
        }
        comparison.assertPowers(grazing(queries, false), TOLERANCE);
        // Where w vanishes, so does the relief: phases of 0.02 leave 1e-4 of the light beside the specular direction,
        // and an error of the expansion that is 2e-5 of the whole weighs a hundred times as much.
        comparison.assertPowers(grazing(queries, true), 10 * TOLERANCE);
    }

    private static List<Query> grazing(List<Query> queries, boolean both) {
        return queries.stream()
                .filter(query -> (-query.pair().w() < 0.01) == both)
                .toList();
    }

    private static final double SUNLIGHT = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH;
    private static final HeightMap FLAT = Comparison.heights(8, 6, 50e-9, (x, y) -> 1e-3);
    private static final double ROUGH_WINDOW = 3e-6;

    @ParameterizedTest
    @CsvSource({"0", "60"})
    void aFlatMirrorReflectsExactlyItsReflectance(double thetaDegrees) {
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(SUNLIGHT);
        double wavelength = 550e-9;
        Direction light = Direction.ofDegrees(thetaDegrees, 0);
        // Trapezoid over a Gaussian of deviation sigma_f / sqrt(2): at a step of half of sigma_f its error is 1e-17.
        double step = 0.5 * window.sigmaFrequency();
        List<Query> queries = new ArrayList<>();
        for (int i = -10; i <= 10; i++) {
            for (int j = -10; j <= 10; j++) {
                queries.add(Comparison.seeing(thetaDegrees, i * step, j * step, wavelength));
            }
        }

        double sum = new Comparison(context, FLAT, SUNLIGHT)
                .spectral(queries).stream().mapToDouble(result -> result[3]).sum();

        // cos(theta_r) d omega = dx dy of the disc. Variation over the peak is of second order in its width, 5e-3.
        double reflected = sum * Math.pow(step * wavelength, 2);
        assertThat(reflected / Gain.reflectance(light.z())).isCloseTo(1, within(TOLERANCE));
    }

    @Test
    void swappedLightAndViewHaveTheSameBrdf() {
        List<Query> there = Comparison.anywhere(41, 60);
        List<Query> back = there.stream()
                .map(query -> new Query(
                        new DirectionPair(query.pair().wr(), query.pair().wi()), query.wavelength()))
                .toList();
        Comparison rough = new Comparison(context, ROUGH, ROUGH_WINDOW);
        List<float[]> forth = rough.spectral(there);
        List<float[]> reversed = rough.spectral(back);

        for (int i = 0; i < forth.size(); i++) {
            // Sums of the same two directions in another order: float32 rounding of u and v, seen through steep flanks.
            assertThat(reversed.get(i)[3]).as("brdf").isCloseTo(forth.get(i)[3], within(1e-3f * forth.get(i)[3]));
        }
    }

    @Test
    void theSurfaceUpsideDownAndTurnedLooksTheSame() {
        // power(u, v, w) = power(-u, -v, -w), and -w at heights h is w at heights -h.
        List<Query> queries = Comparison.anywhere(42, 60);
        List<Query> turned = queries.stream()
                .map(query -> new Query(
                        new DirectionPair(
                                turned(query.pair().wi()), turned(query.pair().wr())),
                        query.wavelength()))
                .toList();
        HeightMap upsideDown = ROUGH.map(height -> -height);

        List<float[]> upright = new Comparison(context, ROUGH, ROUGH_WINDOW).spectral(queries);
        List<float[]> mirrored = new Comparison(context, upsideDown, ROUGH_WINDOW).spectral(turned);

        // Both are off by the tolerance at most.
        Comparison.assertWithin(
                2 * TOLERANCE,
                upright.size(),
                i -> Math.abs(mirrored.get(i)[0] - upright.get(i)[0]) / upright.get(i)[0]);
    }

    private static Direction turned(Direction direction) {
        return new Direction(-direction.x(), -direction.y(), direction.z());
    }
}
