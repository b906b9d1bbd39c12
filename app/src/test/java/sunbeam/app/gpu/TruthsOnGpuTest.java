package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.gpu.Requests.TOLERANCE;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;

/** Laws that hold for mirrors and for every surface, on the GPU. */
@NeedsDisplay
class TruthsOnGpuTest extends InAContext {
    private static final double SUNLIGHT = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH;
    private static final HeightMap FLAT = Surface.of(8, 6, 50e-9, (x, y) -> 1e-3);
    private static final HeightMap ROUGH = Surface.noise(64, 48, 50e-9, 500e-9, 31);
    private static final double ROUGH_WINDOW = 3e-6;

    private static Comparison flat(double coherenceLength) {
        return new Comparison(context, FLAT, Requests.of(coherenceLength, Average.COHERENT));
    }

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
                queries.add(Directions.seeing(thetaDegrees, i * step, j * step, wavelength));
            }
        }

        double sum = flat(SUNLIGHT).spectral(queries).stream()
                .mapToDouble(result -> result[3])
                .sum();

        // cos(theta_r) d omega = dx dy of the disc. Variation over the peak is of second order in its width, 5e-3.
        double reflected = sum * Math.pow(step * wavelength, 2);
        assertThat(reflected / Gain.reflectance(light.z())).isCloseTo(1, within(TOLERANCE));
    }

    @Test
    void swappedLightAndViewHaveTheSameBrdf() {
        List<Query> there = new Directions(41).queries(60);
        List<Query> back = there.stream()
                .map(query -> new Query(
                        new DirectionPair(query.pair().wr(), query.pair().wi()), query.wavelength()))
                .toList();
        Comparison rough = new Comparison(context, ROUGH, Requests.of(ROUGH_WINDOW, Average.COHERENT));
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
        List<Query> queries = new Directions(42).queries(60);
        List<Query> turned = queries.stream()
                .map(query -> new Query(
                        new DirectionPair(
                                turned(query.pair().wi()), turned(query.pair().wr())),
                        query.wavelength()))
                .toList();
        HeightMap upsideDown = ROUGH.map(height -> -height);

        List<float[]> upright =
                new Comparison(context, ROUGH, Requests.of(ROUGH_WINDOW, Average.COHERENT)).spectral(queries);
        List<float[]> mirrored =
                new Comparison(context, upsideDown, Requests.of(ROUGH_WINDOW, Average.COHERENT)).spectral(turned);

        double[] errors = new double[upright.size()];
        for (int i = 0; i < errors.length; i++) {
            errors[i] = Math.abs(mirrored.get(i)[0] - upright.get(i)[0]) / upright.get(i)[0];
        }
        // Both are off by the tolerance at most.
        Errors.of(errors).assertWithin(2 * TOLERANCE, "turned");
    }

    private static Direction turned(Direction direction) {
        return new Direction(-direction.x(), -direction.y(), direction.z());
    }
}
