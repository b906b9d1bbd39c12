package sunbeam.precompute.radial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableDesign;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.spectrum.PowerSpectrum;

/** Means over slopes against sums of colors of points over slopes, by independent windows and grids. */
class SlopeBakerTest {
    private static final GaussianArea AREA =
            GaussianArea.STANDARD.with(CoherenceWindow.ofCoherenceLength(8e-6)).with(Average.ENSEMBLE);
    private static final double SLOPES = 0.08;
    // Standard deviations, beyond which a normal distribution has 1e-4; and the number of slopes summed between, closer
    // than orders are wide.
    private static final double FARTHEST = 4;
    private static final int SIDE = 36;

    private static PowerSpectrum spectrum(HeightMap map, ColorTable table) {
        return RadialBakerTest.spectrum(map, AREA, table.widest(), 1e-4);
    }

    /** The mean over slopes, by a sum over an even grid of them. */
    private static double[] mean(RadialBaker points, double[] place) {
        float[] tilted = new float[3 * SIDE * SIDE];
        double[] weights = new double[SIDE * SIDE];
        for (int i = 0; i < weights.length; i++) {
            double x = FARTHEST * ((i % SIDE + 0.5) / SIDE * 2 - 1);
            double y = FARTHEST * ((Math.floorDiv(i, SIDE) + 0.5) / SIDE * 2 - 1);
            weights[i] = Math.exp(-0.5 * (x * x + y * y));
            tilted[3 * i] = (float) (place[0] + x * SLOPES * place[2]);
            tilted[3 * i + 1] = (float) (place[1] + y * SLOPES * place[2]);
            tilted[3 * i + 2] = (float) place[2];
        }
        float[] colors = points.direct().bake(tilted, ColorBaker.Token.NONE);
        double[] sum = new double[3];
        for (int i = 0; i < colors.length; i++) {
            sum[i % 3] += weights[i / 3] * colors[i];
        }
        double all = Arrays.stream(weights).sum();
        return Arrays.stream(sum).map(value -> value / all).toArray();
    }

    @Test
    void colorsAreMeansOverSlopes() {
        HeightMap map = Surfaces.random(24, 20, 250e-9, 300e-9, 3);
        ColorTable table = ColorTable.within(1e-2, AREA, map.relief(), false, SLOPES);
        PowerSpectrum spectrum = spectrum(map, table);
        CieTable cie = CieTable.load();
        SlopeBaker colors = new SlopeBaker(spectrum, cie, SlopeBaker.pyramid(spectrum, table), table, 0);
        RadialBaker points = new RadialBaker(spectrum, cie, AREA, new TableDesign(0.01, 21), 2, true);
        // The mirror direction, its flank at two and three deviations, orders, and grazing directions.
        List<double[]> places = List.of(
                new double[] {0, 0, -1.9},
                new double[] {0.25, 0.1, -1.8},
                new double[] {0.1, -0.4, -1.8},
                new double[] {0.9, 0.3, -1.4},
                new double[] {-0.2, 1.1, -0.8});
        for (double[] place : places) {
            float[] found = colors.bake(
                    new float[] {(float) place[0], (float) place[1], (float) place[2]}, ColorBaker.Token.NONE);
            double[] mean = mean(points, place);
            for (int c = 0; c < 3; c++) {
                // Cubic polynomials between windows and quadratic splines between frequencies: a thousandth each where
                // it is bright, half a percent on flanks.
                assertThat((double) found[c]).isCloseTo(mean[c], within(0.007 * Math.max(mean[1], mean[c])));
            }
        }
    }
}
