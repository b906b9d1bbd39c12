package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.precompute.patch.HeightMap;

/** Draws of which each interval holds the truth; how many of others do, {@link SimulatedGratingsRun} counts. */
class WaveDirectionTest {
    @ParameterizedTest
    @EnumSource(
            value = SimulatedGrating.Kind.class,
            names = {"CLEAN", "STRAYED", "GAPS", "NOISY", "CHIRPED", "ROWS"})
    void theIntervalHoldsTheDirection(SimulatedGrating.Kind kind) {
        for (long seed = 1; seed <= 3; seed++) {
            SimulatedGrating grating = SimulatedGrating.draw(kind, seed);
            grating.estimate()
                    .flatMap(grating::direction)
                    .ifPresent(direction -> assertThat(grating.directionError(direction))
                            .as(grating.words())
                            .isLessThanOrEqualTo(direction.halfWidth()));
        }
    }

    private static HeightMap grating(double degrees, double noise) {
        SplittableRandom random = new SplittableRandom(1);
        double[] heights = new double[160 * 120];
        double cosine = Math.cos(Math.toRadians(degrees));
        double sine = Math.sin(Math.toRadians(degrees));
        for (int i = 0; i < heights.length; i++) {
            int row = i / 160;
            double s = 100e-9 * (i % 160 * cosine - row * sine);
            heights[i] = 40e-9 * Math.sin(2 * Math.PI * s / 1100e-9) + noise * random.nextGaussian();
        }
        return new HeightMap(160, 120, 100e-9, 100e-9, heights);
    }

    /** In 12 um lines of 1.1 um show a degree by a fifth of a period, and noise of a tenth of them hardly any less. */
    @ParameterizedTest
    @CsvSource({"0", "11.3", "45", "90", "137.2", "179.95"})
    void aGratingsDirectionIsKnownToATenthOfADegree(double degrees) {
        HeightMap map = grating(degrees, 4e-9);
        SpectrumPeak peak = new PeriodFinder(map, false).all().peaks().get(0);
        WaveDirection direction = WaveDirection.of(map, peak, 1100e-9).orElseThrow();
        double error = Math.abs(Math.IEEEremainder(direction.radians() - Math.toRadians(degrees), Math.PI));
        assertThat(error).isLessThanOrEqualTo(direction.halfWidth());
        assertThat(Math.toDegrees(direction.halfWidth())).isLessThan(0.1);
    }

    /** Lines that jump sideways at a row are followed on one side of it. */
    @Test
    void aSlipTurnsNoDirection() {
        HeightMap map = grating(11.3, 1e-9);
        double[] heights = map.toArray();
        for (int row = 40; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                heights[row * map.columns() + column] = map.at(Math.min(map.columns() - 1, column + 4), row);
            }
        }
        HeightMap slipped = new HeightMap(map.columns(), map.rows(), map.pitchX(), map.pitchY(), heights);
        SpectrumPeak peak = new PeriodFinder(slipped, false).all().peaks().get(0);
        PeriodEstimate told = PeriodEstimator.estimate(slipped, peak).orElseThrow();
        assertThat(told.slips()).hasSize(1);
        WaveDirection direction = WaveDirection.of(slipped, peak, told).orElseThrow();
        double error = Math.abs(Math.IEEEremainder(direction.radians() - Math.toRadians(11.3), Math.PI));
        assertThat(error).isLessThanOrEqualTo(direction.halfWidth());
        assertThat(Math.toDegrees(direction.halfWidth())).isLessThan(0.5);
    }

    @Test
    void aSingleRowHasNone() {
        double[] heights = new double[400];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = Math.sin(0.5 * i);
        }
        HeightMap row = new HeightMap(400, 1, 1e-7, 1e-7, heights);
        assertThat(WaveDirection.of(row, new SpectrumPeak(0.5 / (2 * Math.PI * 1e-7), 0, 1, 1), 2 * Math.PI * 2e-7))
                .isEmpty();
    }

    @Test
    void digitsAreThoseThatAreKnown() {
        assertThat(new WaveDirection(Math.toRadians(168.6912), Math.toRadians(0.021)).describe(90))
                .isEqualTo("168.691 +- 0.021 degrees (95 %)");
        assertThat(new WaveDirection(Math.toRadians(168.6912), Math.toRadians(0.021)).describe(0))
                .isEqualTo("-11.309 +- 0.021 degrees (95 %)");
        assertThat(new WaveDirection(Math.toRadians(179.999), Math.toRadians(0.4)).describe(90))
                .isEqualTo("0.00 +- 0.40 degrees (95 %)");
    }
}
