package sunbeam.precompute.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.HeightMap;

class RoughnessTest {
    private static final int SIDE = 64;
    private static final double WIDTH = 12e-6;
    private static final double PERIOD = 1e-6;
    private static final double RELIEF = 100e-9;

    @Test
    void roughSurfacesAreMeasuredInAllDirections() {
        SplittableRandom random = new SplittableRandom(8);
        Roughness roughness = measured(RELIEF, sample -> random.nextGaussian(), WIDTH);
        assertTrue(roughness.isRough() && !roughness.areOrdersIsolated());
        // White noise of a phase of radians scatters everywhere; grazing directions, with small w, leave more in the
        // mirror direction.
        assertTrue(roughness.bright() > 0.95 && roughness.diffracted() > 0.2, roughness.toString());
        assertTrue(roughness.dark() < roughness.mean());
    }

    @Test
    void betweenTheOrdersOfAGratingItIsDark() {
        Roughness grating =
                measured(RELIEF, sample -> Math.sin(2 * Math.PI * (sample % SIDE) * WIDTH / SIDE / PERIOD), WIDTH);
        assertTrue(grating.areOrdersIsolated() && !grating.isRough(), grating.toString());
    }

    @Test
    void windowsOfFewDeviationsHaveNoRoughness() {
        SplittableRandom random = new SplittableRandom(8);
        Roughness narrow = measured(RELIEF, sample -> random.nextGaussian(), WIDTH / 4);
        assertEquals(Roughness.NONE, narrow);
        assertFalse(narrow.isRough());
    }

    private static Roughness measured(double relief, IntToDoubleFunction shape, double coherenceLength) {
        double[] heights = new double[SIDE * SIDE];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = relief * shape.applyAsDouble(i);
        }
        return Roughness.measure(
                new HeightMap(SIDE, SIDE, WIDTH / SIDE, WIDTH / SIDE, heights),
                CoherenceWindow.ofCoherenceLength(coherenceLength),
                WindowOrigin.CENTRE,
                VisibleRange.all(),
                Roughness.Cache.NONE);
    }
}
