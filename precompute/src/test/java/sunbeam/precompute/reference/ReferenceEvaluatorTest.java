package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

class ReferenceEvaluatorTest {
    private static final double WAVELENGTH = 500e-9;

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
}
