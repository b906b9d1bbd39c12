package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.DirectionsRenderer.Query;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

final class DirectionSamplerTest {
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(65e-6);
    private static final HeightMap MAP = new HeightMap(4, 2, 0.625e-6, 1e-6, new double[8]);

    private static DirectionSampler sampler(long seed) {
        return new DirectionSampler(MAP, WINDOW, seed);
    }

    @Test
    void theSameSeedGivesTheSameDirections() {
        DirectionSampler first = sampler(7);
        DirectionSampler second = sampler(7);
        for (int i = 0; i < 20; i++) {
            assertThat(first.uniform()).isEqualTo(second.uniform());
            assertThat(first.aimed()).isEqualTo(second.aimed());
        }
        assertThat(sampler(8).uniform()).isNotEqualTo(sampler(7).uniform());
    }

    @Test
    void directionsAreUnitVectorsAboveTheSurfaceAndWavelengthsVisible() {
        DirectionSampler sampler = sampler(1);
        List<Query> queries = Stream.concat(
                        Stream.generate(sampler::uniform).limit(500),
                        Stream.generate(sampler::aimed).limit(500))
                .toList();
        for (Query query : queries) {
            for (Direction direction : List.of(query.pair().wi(), query.pair().wr())) {
                assertThat(direction.dot(direction)).isCloseTo(1, within(1e-12));
                assertThat(direction.z()).isPositive();
            }
            assertThat(query.wavelength()).isBetween(380e-9, 780e-9);
        }
    }

    @Test
    void uniformDirectionsHaveTheirMeanHalfwayUp() {
        DirectionSampler sampler = sampler(2);
        double mean = Stream.generate(sampler::uniform)
                .limit(4000)
                .mapToDouble(query -> query.pair().wi().z())
                .average()
                .orElseThrow();
        // Cosines are uniform in 0.01..1: mean 0.505, standard error 0.286 / sqrt(4000) = 0.0045; five of them.
        assertThat(mean).isCloseTo(0.505, within(0.023));
    }

    @Test
    void aimedDirectionsHitOrdersWithinTheWidthOfTheWindow() {
        DirectionSampler sampler = sampler(3);
        double sigma = WINDOW.sigmaFrequency();
        for (int i = 0; i < 300; i++) {
            Query query = sampler.aimed();
            DirectionPair pair = query.pair();
            double fx = pair.u() / query.wavelength();
            double fy = pair.v() / query.wavelength();
            // Six standard deviations of a normal deviate; orders lie 41 and 51 of them apart.
            assertThat(Math.abs(fx - Math.rint(fx * 2.5e-6) / 2.5e-6)).isLessThan(6 * sigma);
            assertThat(Math.abs(fy - Math.rint(fy * 2e-6) / 2e-6)).isLessThan(6 * sigma);
        }
    }

    @Test
    void viewsOfALightKeepTheLightEvenWhereItSendsNoOrderUpwards() {
        Direction grazing = Direction.ofDegrees(89.9, 30);
        // Narrower than half a wavelength: there is the specular order alone, which grazes, too.
        HeightMap narrow = new HeightMap(2, 2, 50e-9, 50e-9, new double[4]);
        DirectionSampler sampler = new DirectionSampler(narrow, WINDOW, 5, Optional.of(grazing));
        for (int i = 0; i < 20; i++) {
            for (Query query : List.of(sampler.uniform(), sampler.aimed())) {
                assertThat(query.pair().wi()).isEqualTo(grazing);
                assertThat(query.pair().wr().z()).isPositive();
            }
        }
    }
}
