package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

final class PreviewScaleTest {
    private static final double BUDGET = PreviewScale.BUDGET_NANOSECONDS;
    private static final int FRAMES = 60;

    private static long frame(PreviewScale scale, double fixed, double full) {
        return (long) (fixed + full / scale.divisor() / scale.divisor());
    }

    private static PreviewScale settled(double fixed, double full) {
        PreviewScale scale = PreviewScale.first();
        for (int i = 0; i < FRAMES; i++) {
            scale = scale.after(frame(scale, fixed, full), (long) fixed);
        }
        return scale;
    }

    @Test
    void aFastMethodIsDrawnInFullResolution() {
        assertThat(settled(5e6, 10e6).divisor()).isEqualTo(1);
    }

    @Test
    void everyMethodSettlesWithinTheBudget() {
        for (double full = 1e6; full < 500 * BUDGET; full *= 1.7) {
            PreviewScale scale = settled(5e6, full);
            assertThat((double) frame(scale, 5e6, full))
                    .as("full picture of %s ns", full)
                    .isLessThanOrEqualTo(BUDGET);
        }
    }

    @Test
    void aSlowMeshDoesNotCostTheLastPixel() {
        assertThat(settled(150e6, 100e6).divisor()).isLessThanOrEqualTo(4);
    }

    @Test
    void oneSlowFrameCoarsensTheVeryNext() {
        long slow = 10 * PreviewScale.BUDGET_NANOSECONDS;
        assertThat(new PreviewScale(1, 1e6).after(slow, 0).divisor()).isEqualTo(3);
    }

    @Test
    void oneFrameThatWasHeldUpIsSoonForgotten() {
        PreviewScale steady = settled(5e6, 1e9);
        PreviewScale scale = steady.after(3 * frame(steady, 5e6, 1e9), 15_000_000);
        assertThat(scale.divisor()).isGreaterThan(steady.divisor());
        for (int i = 0; i < 10; i++) {
            scale = scale.after(frame(scale, 5e6, 1e9), 5_000_000);
        }
        assertThat(scale.divisor()).isEqualTo(steady.divisor());
    }

    @Test
    void aSettledScaleMovesByOneStepAtMost() {
        for (double full = 1e6; full < 1e12; full *= 1.3) {
            PreviewScale scale = settled(5e6, full);
            int next = scale.after(frame(scale, 5e6, full), 5_000_000).divisor();
            // Neighboring divisors are at most a factor of 2 apart, from 1 to 2.
            assertThat(next).as("full picture of %s ns", full).isBetween(scale.divisor() / 2, 2 * scale.divisor());
        }
    }
}
