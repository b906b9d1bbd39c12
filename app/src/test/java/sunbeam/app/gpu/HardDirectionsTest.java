package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.gpu.Requests.TOLERANCE;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;

/** Directions and wavelengths at the ends of their ranges, with each kind of plan. */
@NeedsDisplay
class HardDirectionsTest extends InAContext {
    private static final HeightMap ROUGH = Surface.noise(64, 64, 50e-9, 400e-9, 51);

    private static Comparison comparison(double coherenceLength) {
        return new Comparison(context, ROUGH, Requests.of(coherenceLength, Average.COHERENT));
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

        comparison.powerErrors(queries).assertWithin(TOLERANCE, "power");
        comparison.colorErrors(queries.stream().map(Query::pair).toList()).assertWithin(TOLERANCE, "XYZ");
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
        comparison.powerErrors(grazing(queries, false)).assertWithin(TOLERANCE, "one direction grazing");
        // Where w vanishes, so does the relief: phases of 0.02 leave 1e-4 of the light beside the specular direction,
        // and an error of the expansion that is 2e-5 of the whole weighs a hundred times as much.
        comparison.powerErrors(grazing(queries, true)).assertWithin(10 * TOLERANCE, "both directions grazing");
    }

    private static List<Query> grazing(List<Query> queries, boolean both) {
        return queries.stream()
                .filter(query -> (-query.pair().w() < 0.01) == both)
                .toList();
    }
}
