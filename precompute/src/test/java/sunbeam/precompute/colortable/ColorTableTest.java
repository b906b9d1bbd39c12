package sunbeam.precompute.colortable;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ReferenceEvaluator;

class ColorTableTest {
    private static final GaussianArea ENSEMBLE =
            GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(12e-6)).with(Average.ENSEMBLE);

    private static double ensemble(HeightMap map, GaussianArea area, double u, double v) {
        // Only the sum of both directions counts.
        DirectionPair pair = new DirectionPair(new Direction(-u, -v, 1.4), new Direction(0, 0, 0));
        return new ReferenceEvaluator(map, area.window(), WindowOrigin.CENTRE)
                .powers(pair, ColorTable.MIDDLE_WAVELENGTH)
                .ensemble();
    }

    @Test
    void aLevelIsTheMeanOfTheFinestOverItsSurroundings() {
        HeightMap map = Surfaces.random(24, 20, 150e-9, 400e-9, 4);
        ColorTable levels = ColorTable.within(1e-2, ENSEMBLE, map.relief(), false, 0);
        double sigma = levels.sigma();
        for (int number : new int[] {1, 2, 3}) {
            ColorTable.Level level = levels.levels().get(levels.pointLevelCount() + number);
            // Level l adds (2^l - 1) times the finest's variance.
            double added = sigma * Math.sqrt(Math.pow(2, number) - 1);
            double sum = 0;
            double weights = 0;
            for (int i = -8; i <= 8; i++) {
                for (int j = -8; j <= 8; j++) {
                    double weight = Math.exp(-0.5 * (i * i + j * j) / 4.0);
                    sum += weight * ensemble(map, ENSEMBLE, 0.21 + 0.5 * i * added, -0.13 + 0.5 * j * added);
                    weights += weight;
                }
            }
            double mean = sum / weights;
            // The sum stops at four deviations, beyond which lie 1e-4 of the weights.
            assertThat(level.scale() * ensemble(map, level.area(), 0.21, -0.13))
                    .as("level %d", number)
                    .isCloseTo(mean, within(3e-4 * mean));
        }
    }

    /** A slope shifts (u, v) by the slope times w; the width of the finest level is not added twice. */
    @Test
    void levelsOfReliefAreAsWideAsItsSlopesMoveThem() {
        ColorTable table = ColorTable.within(1e-2, ENSEMBLE, 1e-6, false, 0.07);
        assertThat(table.pointLevelCount()).isZero();
        assertThat(table.slopeVariance(0, 1.8)).isCloseTo(Math.pow(0.07 * 1.8, 2), within(1e-12));
        // At grazing directions the level's own width remains.
        double least = Math.pow(table.finestSigma(), 2) - Math.pow(table.sigma(), 2);
        assertThat(table.slopeVariance(0, 0)).isCloseTo(least, within(1e-12));
        assertThat(table.slopeVariance(1, 0)).isCloseTo(least + Math.pow(table.finestSigma(), 2), within(1e-12));
        // At the middle wavelength a level's window is that of its area.
        assertThat(table.widened(least, ColorTable.MIDDLE_WAVELENGTH).sigmaMeters())
                .isCloseTo(table.levels().get(0).area().window().sigmaMeters(), within(1e-12));
    }
}
