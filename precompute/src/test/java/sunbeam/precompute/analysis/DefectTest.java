package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.prepare.ScanFault;
import sunbeam.precompute.prepare.ScanFaults;

/** Gratings with a defect that is higher than their lines, or hides some of them. */
class DefectTest {
    private static final double AMPLITUDE = 40e-9;

    private static GratingPeriod period(HeightMap map) {
        List<ScanFault> faults = ScanFaults.in(map, Optional.empty());
        return GratingPeriod.of(
                new Patch("scan", map, map, "a test", List.of(), List.of(), List.of(), faults, Patch.Repetition.NONE));
    }

    /** Lines on 16 um with noise of a twentieth of their amplitude, and a Gaussian ridge of one standard deviation. */
    private static HeightMap ridge(double period, double turn, double heights, double deviation) {
        SplittableRandom random = new SplittableRandom(1);
        return Surfaces.of(160, 160, 100e-9, (x, y) -> {
            double across = x * Math.cos(1.1) + y * Math.sin(1.1);
            double beyond = (x - 8e-6) * Math.cos(1.1 + turn) + (y + 8e-6) * Math.sin(1.1 + turn);
            return AMPLITUDE
                    * (Math.sin(2 * Math.PI * across / period)
                            + 0.05 * random.nextGaussian()
                            + heights * Math.exp(-beyond * beyond / (2 * deviation * deviation)));
        });
    }

    @ParameterizedTest
    @CsvSource({
        "2e-6, 0, 5, 0.7e-6",
        "2e-6, 0.02, 5, 0.6e-6",
        "2e-6, 0.3, 5, 0.6e-6",
        "1.6e-6, 0.02, 5, 0.5e-6",
        "2e-6, 1.4, 8, 1e-6"
    })
    void aRidgeDoesNotHideLines(double period, double turn, double heights, double deviation) {
        GratingPeriod found = period(ridge(period, turn, heights, deviation));
        assertThat(found.isSeen()).as(found.describe()).isTrue();
        // A tenth: a quarter of a line over the 2.5 periods or more that the ridge leaves on either side.
        assertThat(found.period()).isBetween(0.9 * period, 1.1 * period);
    }

    /** A ridge alone, cut out of noise of one correlation length, leaves no lines: at most one of twelve is probable at 3 in 100. */
    @Test
    void aRidgeInNoiseIsNoGrating() {
        int seen = 0;
        for (long seed = 0; seed < 12; seed++) {
            HeightMap noise = PeriodlessSurface.CORRELATED.draw(seed);
            double[] heights = noise.heights().clone();
            double deviation = 0.06 * noise.columns();
            double high = 4 * noise.relief();
            double turn = 0.26 * seed;
            Arrays.setAll(heights, i -> {
                double x = i % noise.columns() - 0.5 * noise.columns();
                double y = Math.floorDiv(i, noise.columns()) - 0.5 * noise.rows();
                double beyond = (x * Math.cos(turn) + y * Math.sin(turn)) / deviation;
                return heights[i] + high * Math.exp(-0.5 * beyond * beyond);
            });
            seen += period(noise.with(heights)).isSeen() ? 1 : 0;
        }
        assertThat(seen).isLessThan(2);
    }

    /** Lines of 4.5 um of which the longest measured part holds two, and of 0.8 um, of which gaps of 10 rows hold more than one. */
    @ParameterizedTest
    @CsvSource({"4.5e-6, 1.94", "0.8e-6, 1.94", "0.8e-6, 1.5708"})
    void rowsWithoutAMeasurementBetweenOthersHideNoLines(double period, double angle) {
        SplittableRandom random = new SplittableRandom(1);
        HeightMap whole = Surfaces.of(
                200,
                200,
                100e-9,
                (x, y) -> AMPLITUDE
                        * (Math.sin(2 * Math.PI * (x * Math.cos(angle) + y * Math.sin(angle)) / period)
                                + 0.05 * random.nextGaussian()));
        double[] heights = whole.heights().clone();
        for (int first : new int[] {50, 98, 146}) {
            Arrays.fill(heights, first * 200, (first + 10) * 200, -2 * AMPLITUDE);
        }
        GratingPeriod found = period(whole.with(heights));
        assertThat(found.isSure()).as(found.describe()).isTrue();
        assertThat(period).isBetween(found.low(), found.high());
    }
}
