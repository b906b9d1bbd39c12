package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.ModelError.Incidence;

class ModelErrorTest {
    private static final double PITCH = 10e-9;

    private static ModelError rule(double meanSlope) {
        return new ModelError(meanSlope, 0, 0, 0);
    }

    @Test
    void theMeanSlopeOfAGratingIsTwiceItsDepthOverItsPeriod() {
        double period = 100 * PITCH;
        HeightMap sine = Surfaces.of(1000, 1, PITCH, (x, y) -> 50e-9 * Math.sin(2 * Math.PI * x / period));

        // 10 samples a quarter period and a missing seam: 1e-3.
        assertThat(ModelError.of(sine).meanSlope()).isCloseTo(2 * 100e-9 / period, within(4e-4));
    }

    /** Three gratings of docs/examples/coupled_waves.py, from the middle of their ranges. */
    @Test
    void theRuleHoldsForGratingsThatWereComputedRigorously() {
        // sinusoidal, metal, period 1.4195 um, depth 56.17 nm, 21.58 degrees: 0.0158.
        assertThat(between(2 * 56.17e-3 / 1.4195, Incidence.NEAR_NORMAL, 0.0158))
                .isTrue();
        // blazed, metal, period 1.3454 um, depth 188.07 nm, 15.35 degrees: 0.196.
        assertThat(between(2 * 188.07e-3 / 1.3454, Incidence.NEAR_NORMAL, 0.196))
                .isTrue();
        // blazed, dielectric, period 1.9533 um, depth 480.37 nm, 57.29 degrees: 0.228.
        assertThat(between(2 * 480.37e-3 / 1.9533, Incidence.OBLIQUE, 0.228)).isTrue();
    }

    private static boolean between(double meanSlope, Incidence incidence, double error) {
        return rule(meanSlope).low(incidence) <= error
                && error <= rule(meanSlope).high(incidence);
    }

    @Test
    void describesSlopesBeyondTheRule() {
        assertThat(rule(1.3).describe()).contains("beyond the rule");
        assertThat(rule(0.2).describe()).contains("9.6 %").contains("mean slope 0.20;");
    }

    @Test
    void aSineHasTheSlopesOfItsFormula() {
        double steepest = 2 * Math.PI * 100e-9 / 2e-6;
        ModelError slopes =
                ModelError.of(Surfaces.of(800, 10, PITCH, (x, y) -> 5e-3 + 100e-9 * Math.sin(2 * Math.PI * x / 2e-6)));
        assertThat(slopes.largestSlope()).isCloseTo(steepest, within(7e-4 * steepest));
        assertThat(slopes.rmsSlope()).isCloseTo(steepest / Math.sqrt(2), within(3e-3 * steepest));
    }

    @Test
    void aSlopeOfExactly30DegreesIsNotSteeper() {
        assertThat(ModelError.of(Surfaces.of(50, 1, PITCH, (x, y) -> x / Math.sqrt(3)))
                        .steepShare())
                .isZero();
        assertThat(ModelError.of(Surfaces.of(1, 1, PITCH, (x, y) -> 3e-9))).isEqualTo(rule(0));
    }

    @Test
    void namesTheShareOfTheSurface() {
        // Left half flat, right half at 40 degrees: 31 of 63 steps climb.
        double rise = Math.tan(Math.toRadians(40));
        HeightMap half = Surfaces.of(64, 8, PITCH, (x, y) -> rise * Math.max(0, x - 32 * PITCH));

        assertThat(ModelError.of(half).warning().orElseThrow())
                .contains("49.2 % of the surface", "steeper than 30 degrees");
    }

    @Test
    void forgivesTheWallOfAGratingAndTheSeam() {
        // One wall in 127 steps; the jump from the ramp's end to its start is not considered.
        assertThat(ModelError.of(Surfaces.of(128, 1, PITCH, (x, y) -> x < 64 * PITCH ? 0 : 1e-6))
                        .warning())
                .isEmpty();
    }
}
