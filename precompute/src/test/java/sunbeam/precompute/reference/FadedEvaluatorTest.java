package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.special.BesselJ;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightMap;

class FadedEvaluatorTest {
    private static final double WAVELENGTH = 500e-9;

    /** u and v as given, w = -2: only their sums count. */
    private static DirectionPair pair(double u, double v) {
        return new DirectionPair(new Direction(-u, -v, 2), new Direction(0, 0, 0));
    }

    @Test
    void aMirrorIsOneInSpecularDirectionAndFadesAsTheFadingsSpectrum() {
        double width = 10e-6;
        FadedEvaluator mirror = new FadedEvaluator(new HeightMap(100, 60, width / 100, width / 100, new double[6000]));
        // A few hundred roundings.
        assertThat(mirror.power(pair(0, 0), WAVELENGTH)).isCloseTo(1, within(1e-12));
        // cos^2 has half its amplitude 1 / W away, and nothing 2 / W away.
        assertThat(mirror.power(pair(WAVELENGTH / width, 0), WAVELENGTH)).isCloseTo(0.25, within(1e-12));
        assertThat(mirror.power(pair(2 * WAVELENGTH / width, 0), WAVELENGTH)).isLessThan(1e-20);
    }

    @Test
    void theFirstOrderOfASineHasItsBesselPowerBetweenTheBinsOfTheScan() {
        double amplitude = 40e-9;
        double period = 0.9e-6;
        double[] heights = new double[512 * 4];
        double pitch = 20e-6 / 512;
        for (int i = 0; i < heights.length; i++) {
            heights[i] = amplitude * Math.sin(2 * Math.PI * (i % 512) * pitch / period + 0.3);
        }
        FadedEvaluator sine = new FadedEvaluator(new HeightMap(512, 4, pitch, pitch, heights));
        double expected = Math.pow(BesselJ.value(1, 2 * Math.PI / WAVELENGTH * 2 * amplitude), 2);
        // 22.2 periods: what other orders' side lobes leave 22 bins away is below 1e-4 in amplitude.
        assertThat(sine.power(pair(WAVELENGTH / period, 0), WAVELENGTH) / expected)
                .isCloseTo(1, within(1e-3));
    }
}
