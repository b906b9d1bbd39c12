package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.patch.HeightMap;

/**
 * Lattices whose rows lie along the scan's: two of their waves have the same frequency along its rows, and beat from row to
 * row. That is no slip.
 */
final class AlignedLatticesTest {
    private static final int SAMPLES = 256;
    private static final double WIDTH = 20e-6;
    private static final double NOISE = 0.1;

    @ParameterizedTest
    @CsvSource({
        // Basis vectors, nanometres.
        "900, 0, 0, 900",
        "900, 900, -900, 900",
        "1300, 0, 650, 1125.833",
        "0, 1300, 1125.833, 650",
        "700, 1100, -700, 1100",
        "1900, 600, -1900, 600"
    })
    void theirWavesAreOfOnePiece(double ux, double uy, double vx, double vy) {
        double determinant = (ux * vy - uy * vx) * 1e-9;
        double[] first = {vy / determinant, -vx / determinant};
        double[] second = {-uy / determinant, ux / determinant};
        HeightMap map = dots(first, second);
        Periodicity found = new PeriodFinder(map, false).all();
        assertThat(found.found()).isTrue();
        SpectrumPeak peak = found.peaks().get(0);
        PeriodEstimate told = PeriodEstimator.estimate(map, peak).orElseThrow();
        assertThat(told.slips()).isEmpty();
        assertThat(told.doubt()).isEqualTo(PeriodEstimate.Doubt.NONE);
        double truth = nearest(peak, first, second);
        assertThat(told.low()).isLessThanOrEqualTo(truth);
        assertThat(told.high()).isGreaterThanOrEqualTo(truth);
        // A scan of 20 um tells 1 um to 1 / 20 of it times what noise of a tenth leaves of a phase, a few hundredths.
        assertThat(told.period()).isCloseTo(truth, within(0.005 * truth));
    }

    /** Smooth dots: three waves of each direction. */
    private static HeightMap dots(double[] first, double[] second) {
        Random noise = new Random(17);
        double[] heights = new double[SAMPLES * SAMPLES];
        for (int i = 0; i < heights.length; i++) {
            double x = i % SAMPLES * WIDTH / SAMPLES;
            double y = -(i / SAMPLES) * WIDTH / SAMPLES;
            double s = 0.5 + 0.5 * Math.cos(2 * Math.PI * (first[0] * x + first[1] * y));
            double t = 0.5 + 0.5 * Math.cos(2 * Math.PI * (second[0] * x + second[1] * y));
            heights[i] = 50e-9 * (s * s * t * t + NOISE * noise.nextGaussian());
        }
        return new HeightMap(SAMPLES, SAMPLES, WIDTH / SAMPLES, WIDTH / SAMPLES, heights);
    }

    /** Period of the reciprocal lattice's vector that a peak stands on, metres. */
    private static double nearest(SpectrumPeak peak, double[] first, double[] second) {
        double nearest = Double.POSITIVE_INFINITY;
        double period = 0;
        for (int i = -3; i <= 3; i++) {
            for (int j = -3; j <= 3; j++) {
                double x = i * first[0] + j * second[0];
                double y = i * first[1] + j * second[1];
                double away = Math.hypot(x - peak.frequencyX(), y - peak.frequencyY());
                if (away < nearest) {
                    nearest = away;
                    period = 1 / Math.hypot(x, y);
                }
            }
        }
        return period;
    }
}
