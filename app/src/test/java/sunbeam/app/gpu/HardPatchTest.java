package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.gpu.Requests.TOLERANCE;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.SamplingCheck;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.prepare.MissingHeights;

/** Patches of odd shapes and with faults. The tolerance holds for all of them, against the same samples. */
@NeedsDisplay
class HardPatchTest extends InAContext {
    private static void assertKept(HeightMap map, double coherenceLength, String what) {
        new Comparison(context, map, Requests.of(coherenceLength, Average.COHERENT))
                .powerErrors(new Directions(21).queries(100))
                .assertWithin(TOLERANCE, what);
    }

    @ParameterizedTest
    @CsvSource({"61, 53", "64, 27", "127, 1", "1, 64", "2, 2"})
    void sidesOddEvenPrimeAndSingle(int columns, int rows) {
        HeightMap map = Surface.noise(columns, rows, 60e-9, 300e-9, 12);

        // Of the longer side, so that every direction sees something.
        assertKept(map, 0.5 * Math.max(map.width(), map.height()) + 300e-9, columns + " x " + rows);
    }

    @Test
    void oneSpikeOfDust() {
        HeightMap skin = Surface.waves(64, 64, 50e-9, 100e-9);
        double[] heights = skin.toArray();
        heights[20 * 64 + 30] = 3e-6;
        assertKept(new HeightMap(64, 64, 50e-9, 50e-9, heights), 3e-6, "dust");
    }

    @Test
    void missingSamplesOnceFilled() {
        double[] heights = Surface.noise(64, 64, 50e-9, 375e-9, 15).toArray();
        for (int i = 0; i < heights.length; i += 17) {
            heights[i] = Double.NaN;
        }
        assertKept(
                MissingHeights.fill(new HeightMap(64, 64, 50e-9, 50e-9, heights))
                        .field(),
                3e-6,
                "filled");
    }

    @Test
    void samplesTooCoarseAreComputedAsTheyAreAndTold() {
        HeightMap coarse = Surface.noise(32, 32, 150e-9, 300e-9, 16);
        assertThat(SamplingCheck.pitch(coarse)).isPresent();
        assertKept(coarse, 3e-6, "coarse");
    }
}
