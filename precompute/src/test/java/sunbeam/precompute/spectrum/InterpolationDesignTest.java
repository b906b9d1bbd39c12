package sunbeam.precompute.spectrum;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class InterpolationDesignTest {
    @Test
    void skirtsAreInterpolatedAsWellAsPeaks() {
        double skirt = 4.6;
        InterpolationDesign design = InterpolationDesign.within(1e-4, skirt);
        InterpolationDesign.Spread spread = design.spread();
        for (double distance = 0; distance <= skirt; distance += 0.37) {
            double f = 0.3 + distance * design.deviation();
            double sum = 0;
            for (int m = (int) Math.ceil(f - 0.5 * design.taps()); m <= f + 0.5 * design.taps(); m++) {
                sum += design.kernel(f - m) * spread.value(m - 0.3);
            }
            double gauss = Math.exp(-0.5 * distance * distance);
            // The requested error, with a margin for places between those of the design. A design relative to the peak
            // errs by 2 % at four deviations.
            assertThat(Math.abs(sum / gauss - 1)).as("%s deviations", distance).isLessThan(2e-4);
        }
    }
}
