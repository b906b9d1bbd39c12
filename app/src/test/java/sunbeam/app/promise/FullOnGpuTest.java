package sunbeam.app.promise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.app.gpu.InAContext;
import sunbeam.precompute.errors.ErrorStatistics;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/** Method {@code full} on the GPU in directions at the ends of their ranges; closed forms and laws are those of the reference. */
class FullOnGpuTest extends InAContext {
    private static final double TOLERANCE = 1e-3;
    private static final CoherenceWindow SHORT = CoherenceWindow.ofCoherenceLength(3e-6);
    private static final HeightMap ROUGH = new HeightMap(
            64,
            64,
            50e-9,
            50e-9,
            new SplittableRandom(51).doubles(64 * 64, 0, 400e-9).toArray());

    private static RandomCase rough(CoherenceWindow window, boolean colors, List<Query> queries) {
        GaussianArea area = new GaussianArea(window, WindowOrigin.CENTRE, Average.COHERENT);
        return new RandomCase(51, "rough", ROUGH, area, TOLERANCE, "given", colors, queries);
    }

    private static Query query(Direction light, Direction view, double wavelength) {
        return new Query(new DirectionPair(light, view), wavelength);
    }

    private static void assertKept(RandomCase made, double tolerance) {
        ErrorStatistics errors = made.measure(context).errors();
        assertThat(errors.count()).isGreaterThan(4);
        assertThat(errors.keep(tolerance)).as("%s: %s", made, errors).isTrue();
    }

    /** Coherence lengths that lead to a grid, to rays and to single orders. */
    @ParameterizedTest
    @CsvSource({"3e-6, false", "3e-6, true", "10e-6, false", "10e-6, true", "65e-6, false", "65e-6, true"})
    void exactlySpecular(double coherenceLength, boolean colors) {
        List<Query> queries = IntStream.rangeClosed(0, 17)
                .mapToObj(i -> query(Direction.ofDegrees(5 * i, 30), Direction.ofDegrees(5 * i, 210), 500e-9))
                .toList();
        assertKept(rough(CoherenceWindow.ofCoherenceLength(coherenceLength), colors, queries), TOLERANCE);
    }

    /** Asserts rho and brdf of each query, relative to its power. */
    private static void assertGains(List<Query> queries, double tolerance) {
        RandomCase made = rough(SHORT, false, queries);
        List<float[]> computed = made.evaluate(context, made.plan());
        for (int i = 0; i < queries.size(); i++) {
            DirectionPair pair = queries.get(i).pair();
            double power = computed.get(i)[0];
            assertThat(computed.get(i)[2] / power / Gain.relativeRadiance(pair))
                    .as("rho at %s", pair)
                    .isCloseTo(1, within(tolerance));
            assertThat(computed.get(i)[3]
                            / power
                            / Gain.brdf(pair, SHORT, queries.get(i).wavelength()))
                    .as("brdf at %s", pair)
                    .isCloseTo(1, within(tolerance));
        }
    }

    /** Light and view that nearly cancel: factors of 1 + wi . wr lost all digits but one at 89.9 degrees. */
    @Test
    void grazingMirrorsHaveTheirRadianceToo() {
        List<Query> queries = IntStream.of(8950, 8990, 8999)
                .mapToObj(hundredths -> hundredths / 100.0)
                .map(theta -> query(Direction.ofDegrees(theta, 20), Direction.ofDegrees(theta, 200.01), 500e-9))
                .toList();
        // Components near 1 are rounded by 6e-8, of a sum of 3.9e-4 at 89.99 degrees: 1.5e-4, and its square.
        assertGains(queries, 3e-4);
    }

    @Test
    void grazingLightAndViewStayFinite() {
        List<Query> bothGraze = new ArrayList<>();
        List<Query> oneGrazes = new ArrayList<>();
        for (double phi = 0; phi < 360; phi += 15) {
            // cos(89.9 degrees) = 1.7e-3, |w| = 3.5e-3.
            bothGraze.add(query(Direction.ofDegrees(89.9, phi), Direction.ofDegrees(89.9, 100), 450e-9));
            oneGrazes.add(query(Direction.ofDegrees(89.9, phi), Direction.ofDegrees(20, 100), 450e-9));
            oneGrazes.add(query(Direction.ofDegrees(30, phi), Direction.ofDegrees(89.9, 100), 450e-9));
        }
        // The factors are sums and cosines of float32 directions: 89.9 degrees has a cosine right to 4e-5, squared.
        assertGains(bothGraze, TOLERANCE);
        assertGains(oneGrazes, TOLERANCE);
        assertKept(rough(SHORT, false, oneGrazes), TOLERANCE);
        // Where w vanishes, so does the relief: phases of 0.02 leave 1e-4 of the light beside the specular direction,
        // and an error of the expansion that is 2e-5 of the whole weighs a hundred times as much.
        assertKept(rough(SHORT, false, bothGraze), 10 * TOLERANCE);
    }
}
