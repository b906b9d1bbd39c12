package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;

class CoherentSamplesTest {
    private static final double WAVELENGTH = 500e-9;

    private static HeightMap rough(int columns, int rows, double offset) {
        SplittableRandom random = new SplittableRandom(3);
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = offset + 400e-9 * random.nextDouble();
        }
        return new HeightMap(columns, rows, 80e-9, 95e-9, heights);
    }

    /** Windows smaller and larger than the patch, the latter with folded replicas. */
    @Test
    void powerIsTheReferences() {
        HeightMap map = rough(33, 20, 1e-3);
        DirectionPair pair = new DirectionPair(Direction.ofDegrees(20, 30), Direction.ofDegrees(50, 200));
        for (double length : new double[] {1e-6, 3e-6, 12e-6}) {
            for (WindowOrigin origin : WindowOrigin.values()) {
                CoherenceWindow window = CoherenceWindow.ofCoherenceLength(length);
                double exact = new ReferenceEvaluator(map, window, origin).coherent(pair, WAVELENGTH);
                double power = new CoherentSamples(map, window, origin)
                        .at(pair, WAVELENGTH)
                        .coherent();
                // An offset of 1 mm rounds heights to 1e-19 m, 3e-12 of a wavelength.
                assertThat(power).isCloseTo(exact, within(1e-10 * Math.sqrt(exact)));
            }
        }
    }

    @Test
    void theSpecularShareIsThatOfTheMeanPhase() {
        // Two heights a quarter wavelength apart under normal light cancel.
        double[] heights = new double[64];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = i % 2 * WAVELENGTH / 4;
        }
        HeightMap map = new HeightMap(8, 8, 80e-9, 80e-9, heights);
        CoherentSamples samples =
                new CoherentSamples(map, CoherenceWindow.ofCoherenceLength(1e-6), WindowOrigin.CENTRE);
        Direction normal = Direction.ofDegrees(0, 0);
        assertThat(samples.at(new DirectionPair(normal, normal), WAVELENGTH).specular())
                .isLessThan(1e-28);
        assertThat(samples.at(new DirectionPair(normal, normal), WAVELENGTH / 2).specular())
                .isCloseTo(1, within(1e-14));
    }
}
