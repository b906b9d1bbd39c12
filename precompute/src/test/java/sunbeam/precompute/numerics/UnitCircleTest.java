package sunbeam.precompute.numerics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class UnitCircleTest {
    @Test
    void pointsAreThoseOfTheLibrary() {
        SplittableRandom random = new SplittableRandom(7);
        for (double largest : new double[] {1e-9, 1e-3, 4, 100, 1e6}) {
            double[] angles = new double[1000];
            for (int i = 0; i < angles.length; i++) {
                angles[i] = largest * (2 * random.nextDouble() - 1);
            }
            double[] sines = angles.clone();
            double[] cosines = new double[angles.length];
            UnitCircle.points(sines, cosines);
            // A few units in the last place.
            double rounding = 4e-16 * Math.max(4, largest);
            for (int i = 0; i < angles.length; i++) {
                assertThat(cosines[i]).as("cos %s", angles[i]).isCloseTo(Math.cos(angles[i]), within(rounding));
                assertThat(sines[i]).as("sin %s", angles[i]).isCloseTo(Math.sin(angles[i]), within(rounding));
            }
        }
    }
}
