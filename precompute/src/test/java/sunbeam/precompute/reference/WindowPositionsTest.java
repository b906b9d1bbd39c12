package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightMap;

/** The ensemble average is the mean over positions of the window; moving the window is moving the periodic patch. */
class WindowPositionsTest {
    private static final int COLUMNS = 13;
    private static final int ROWS = 8;
    private static final double WAVELENGTH = 500e-9;
    // A window that spans half of the patch: its position matters.
    private static final CoherenceWindow WINDOW = new CoherenceWindow(0.25e-6);
    private static final HeightMap ROUGH = Surfaces.random(COLUMNS, ROWS, 100e-9, 400e-9, 3);

    private final SplittableRandom random = new SplittableRandom(8);

    private static double coherent(int right, int down, DirectionPair pair) {
        double[] heights = new double[COLUMNS * ROWS];
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                heights[row * COLUMNS + column] =
                        ROUGH.at(Math.floorMod(column - right, COLUMNS), Math.floorMod(row - down, ROWS));
            }
        }
        HeightMap shifted = new HeightMap(COLUMNS, ROWS, ROUGH.pitchX(), ROUGH.pitchY(), heights);
        return new ReferenceEvaluator(shifted, WINDOW, WindowOrigin.CENTRE).coherent(pair, WAVELENGTH);
    }

    private static double ensemble(DirectionPair pair) {
        return new ReferenceEvaluator(ROUGH, WINDOW, WindowOrigin.CENTRE)
                .powers(pair, WAVELENGTH)
                .ensemble();
    }

    @Test
    void meanOverAllPositionsIsTheEnsembleAverage() {
        for (int i = 0; i < 20; i++) {
            DirectionPair pair = DirectionPairs.random(random);
            double sum = 0;
            for (int right = 0; right < COLUMNS; right++) {
                for (int down = 0; down < ROWS; down++) {
                    sum += coherent(right, down, pair);
                }
            }
            double expected = ensemble(pair);
            // Cross terms of different bins cancel to the last digit over whole periods.
            assertThat(sum / (COLUMNS * ROWS)).isCloseTo(expected, within(1e-9 * expected));
        }
    }

    @Test
    void meanOverRandomPositionsConvergesToTheEnsembleAverage() {
        DirectionPair pair = DirectionPairs.seeing(20, 1.1e6, -0.7e6, WAVELENGTH);
        double expected = ensemble(pair);
        double sum = 0;
        double squares = 0;
        int drawn = 0;
        double firstError = Double.NaN;
        for (int count : new int[] {25, 2500}) {
            for (; drawn < count; drawn++) {
                double power = coherent(random.nextInt(COLUMNS), random.nextInt(ROWS), pair);
                sum += power;
                squares += power * power;
            }
            double mean = sum / count;
            double standardError = Math.sqrt((squares / count - mean * mean) / count);
            // Four standard errors: one seed in 16,000 would miss.
            assertThat(mean).as("mean of %d", count).isCloseTo(expected, within(4 * standardError));
            if (Double.isNaN(firstError)) {
                firstError = standardError;
            } else {
                assertThat(standardError)
                        .as("a hundred times as many positions")
                        .isLessThan(0.15 * firstError);
            }
        }
        // One position alone is speckle: it says little of the mean.
        assertThat(firstError / expected).isGreaterThan(0.05);
    }
}
