package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;

/** The ensemble average is the mean over positions of the window, or of the periodic patch. */
class WindowPositionsTest {
    private static final int COLUMNS = 13;
    private static final int ROWS = 8;
    private static final double WAVELENGTH = 500e-9;
    // A window as wide as half of the patch: its position matters.
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
            // Cross terms of different bins cancel over whole periods.
            assertThat(sum / (COLUMNS * ROWS)).isCloseTo(expected, within(1e-9 * expected));
        }
    }

    /** |sum g(x - center) p exp(2 pi i f x)|^2 over all samples of the periodic patch, by the square of the window's integral. */
    private static double windowedAt(HeightMap map, double sigma, double cx, double cy, DirectionPair pair) {
        double real = 0;
        double imaginary = 0;
        double pitch = map.pitchX();
        int reach = (int) Math.ceil(9 * sigma / pitch) + 1;
        for (int i = (int) (cx / pitch) - reach; i <= cx / pitch + reach; i++) {
            for (int j = (int) (cy / pitch) - reach; j <= cy / pitch + reach; j++) {
                double x = i * pitch;
                double y = j * pitch;
                double gauss = Math.exp(-0.5 * (Math.pow(x - cx, 2) + Math.pow(y - cy, 2)) / (sigma * sigma));
                // Rows run downwards.
                double height = map.at(Math.floorMod(i, map.columns()), Math.floorMod(-j, map.rows()));
                double phase = 2 * Math.PI / WAVELENGTH * (pair.w() * height + pair.u() * x + pair.v() * y);
                real += gauss * Math.cos(phase);
                imaginary += gauss * Math.sin(phase);
            }
        }
        double integral = 2 * Math.PI * Math.pow(sigma / pitch, 2);
        return (real * real + imaginary * imaginary) / (integral * integral);
    }

    /** A window of 2.8 samples: with positions between samples the definition is exact. */
    @Test
    void theEnsembleOfACoarseWindowIsTheMeanOverPositionsBetweenTheSamplesToo() {
        double pitch = 350e-9;
        HeightMap map = Surfaces.random(5, 4, pitch, 300e-9, 9);
        CoherenceWindow window = CoherenceWindow.ofCoherenceLength(2.8 * pitch);
        // A trigonometric polynomial over the period; the window's spectrum is negligible at 8 steps a sample.
        int perSample = 8;
        double largest = 0;
        for (int n = 0; n < 4; n++) {
            DirectionPair pair = DirectionPairs.random(random);
            double all = 0;
            double onSamples = 0;
            for (int i = 0; i < 5 * perSample; i++) {
                for (int j = 0; j < 4 * perSample; j++) {
                    double power =
                            windowedAt(map, window.sigmaMeters(), i * pitch / perSample, j * pitch / perSample, pair);
                    all += power / (20 * perSample * perSample);
                    onSamples += i % perSample == 0 && j % perSample == 0 ? power / 20 : 0;
                }
            }
            double expected = new ReferenceEvaluator(map, window, WindowOrigin.CENTRE)
                    .powers(pair, WAVELENGTH)
                    .ensemble();
            assertThat(all).isCloseTo(expected, within(1e-9 * expected));
            largest = Math.max(largest, Math.abs(onSamples / expected - 1));
        }
        // Over positions at samples alone it is another mean.
        assertThat(largest).isGreaterThan(1e-3);
    }
}
