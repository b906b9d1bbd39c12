package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

final class PreviewScaleTest {
    /** Time of a frame whose full picture takes {@code full} nanoseconds, on a machine without overhead. */
    private static PreviewScale settled(double full) {
        PreviewScale scale = PreviewScale.first();
        for (int frame = 0; frame < 5; frame++) {
            scale = scale.after((long) (full / scale.divisor() / scale.divisor()));
        }
        return scale;
    }

    @Test
    void aFastMethodIsDrawnInFullResolution() {
        assertThat(settled(30e6).divisor()).isEqualTo(1);
    }

    @Test
    void everyMethodSettlesWithinTheBudget() {
        for (double full = 1e6; full < PreviewScale.BUDGET_NANOSECONDS * 1000.0; full *= 1.7) {
            int divisor = settled(full).divisor();
            assertThat(full / divisor / divisor).as("full picture of %s ns", full)
                    .isLessThanOrEqualTo(PreviewScale.BUDGET_NANOSECONDS);
        }
    }

    @Test
    void oneSlowFrameCoarsensTheVeryNext() {
        PreviewScale slow = new PreviewScale(1).after(4 * PreviewScale.BUDGET_NANOSECONDS);
        assertThat(slow.divisor()).isEqualTo(2);
    }

    @Test
    void aSettledScaleDoesNotSwing() {
        for (double full = 1e6; full < 1e12; full *= 1.3) {
            PreviewScale scale = settled(full);
            PreviewScale next = scale.after((long) (full / scale.divisor() / scale.divisor()));
            assertThat(next).as("full picture of %s ns", full).isEqualTo(scale);
        }
    }

    @Test
    void aPreviewOfATinyWindowHasAPixel() {
        assertThat(new PreviewScale(32).reduced(1)).isEqualTo(1);
        assertThat(new PreviewScale(3).reduced(10)).isEqualTo(4);
    }
}
