package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class MovingScaleTest {
    private static final double BUDGET = MovingScale.BUDGET_NANOSECONDS;

    private static double frame(int divisor, double fixed, double full) {
        return fixed + full / divisor / divisor;
    }

    private static void draw(MovingScale scale, int frames, double fixed, double full) {
        for (int i = 0; i < frames; i++) {
            scale.frame((long) frame(scale.divisor(), fixed, full));
        }
    }

    @Test
    void whatIsFastIsDrawnInFullResolution() {
        MovingScale scale = new MovingScale();
        draw(scale, 10, 5e6, 15e6);
        assertThat(scale.divisor()).isEqualTo(1);
    }

    @Test
    void aFixedPartDoesNotHoldBackTheScale() {
        // 1:2 takes 24 ms; a scale that takes all of 1:3's 15 ms for the pixels' foresees 33 ms.
        MovingScale scale = new MovingScale();
        draw(scale, 20, 8e6, 64e6);
        assertThat(scale.divisor()).isEqualTo(2);
    }

    @Test
    void settledFramesKeepToTheirTimeNearlyAlways() {
        for (double full = 1e6; full < 500 * BUDGET; full *= 1.7) {
            MovingScale scale = new MovingScale();
            draw(scale, 60, 5e6, full);
            int late = 0;
            for (int i = 0; i < 300; i++) {
                double taken = frame(scale.divisor(), 5e6, full);
                late += taken > BUDGET ? 1 : 0;
                scale.frame((long) taken);
            }
            // A finer scale is tried again after some 50 frames, for three: the first does not count, nor does one
            // alone.
            assertThat(late).as("full picture of %s ns", full).isLessThanOrEqualTo(3 * 300 / 50);
        }
    }

    @Test
    void roomForPicturesOfAnotherSizeDoesNotCount() {
        MovingScale scale = new MovingScale();
        int before = 0;
        for (int i = 0; i < 30; i++) {
            boolean isNew = scale.divisor() != before;
            before = scale.divisor();
            scale.frame((long) (frame(before, 5e6, 60e6) + (isNew ? 100e6 : 0)));
        }
        assertThat(scale.divisor()).isEqualTo(2);
    }

    @Test
    void followsAtOnceWhereAllTakesLonger() {
        MovingScale scale = new MovingScale();
        draw(scale, 60, 5e6, 15e6);
        draw(scale, 12, 5e6, 400e6);
        assertThat(frame(scale.divisor(), 5e6, 400e6)).isLessThanOrEqualTo(BUDGET);
    }

    /** A mesh of millions of triangles: no scale keeps to the budget, and a mosaic would be no faster. */
    @Test
    void whatFewerPixelsDoNotMakeFasterIsDrawnInFullResolution() {
        for (double fixed : new double[] {1.2 * BUDGET, 3 * BUDGET, 10 * BUDGET}) {
            MovingScale scale = new MovingScale();
            draw(scale, 400, fixed, 0.1 * BUDGET);
            assertThat(scale.divisor()).as("%s ns whatever the scale", fixed).isEqualTo(1);
        }
    }

    /** Pixels that take longer than all else are as few as leave most of a frame to that. */
    @Test
    void besideALongFixedPartPixelsGetAThirdOfTheBudget() {
        MovingScale scale = new MovingScale();
        draw(scale, 60, 3 * BUDGET, 12 * BUDGET);
        double pixels = frame(scale.divisor(), 0, 12 * BUDGET);
        assertThat(pixels).isLessThan(0.5 * BUDGET);
        assertThat(scale.divisor()).isLessThan(16);
    }

    @Test
    void aLongFixedPartIsForgottenOnceFramesTakeLess() {
        MovingScale scale = new MovingScale();
        draw(scale, 400, 10 * BUDGET, 0.1 * BUDGET);
        draw(scale, 60, 5e6, 3 * BUDGET);
        assertThat(frame(scale.divisor(), 5e6, 3 * BUDGET)).isLessThanOrEqualTo(BUDGET);
    }

    @Test
    void comesBackWhereAllTakesLessAgain() {
        MovingScale scale = new MovingScale();
        draw(scale, 60, 5e6, 15e6);
        draw(scale, 60, 5e6, 900e6);
        assertThat(scale.divisor()).isGreaterThan(4);
        draw(scale, 500, 5e6, 15e6);
        assertThat(scale.divisor()).isEqualTo(1);
    }

    @Test
    void aSecondThatWasHeldUpIsSoonForgotten() {
        MovingScale scale = new MovingScale();
        draw(scale, 60, 5e6, 60e6);
        int settled = scale.divisor();
        scale.frame((long) 1e9);
        scale.frame((long) 1e9);
        draw(scale, 300, 5e6, 60e6);
        assertThat(scale.divisor()).isEqualTo(settled);
    }

    /** A garbage collection, say: frames of 45 ms are not far from the budget. */
    @ParameterizedTest
    @ValueSource(doubles = {10e6, 40e6, 50e6, 60e6})
    void oneFrameThatWasHeldUpChangesNothing(double full) {
        MovingScale scale = new MovingScale();
        draw(scale, 60, 5e6, full);
        int settled = scale.divisor();
        for (double budgets = 1.1; budgets < 20; budgets *= 1.5) {
            scale.frame((long) (budgets * BUDGET));
            assertThat(scale.divisor()).as("after %s budgets", budgets).isEqualTo(settled);
            draw(scale, 20, 5e6, full);
            assertThat(scale.divisor())
                    .as("some time after %s budgets", budgets)
                    .isEqualTo(settled);
        }
    }

    @Test
    void unevenFramesDoNotMakeItSwing() {
        MovingScale scale = new MovingScale();
        SplittableRandom random = new SplittableRandom(5);
        int changes = 0;
        for (int i = 0; i < 600; i++) {
            int before = scale.divisor();
            scale.frame((long) (frame(before, 8e6, 64e6) * (0.8 + 0.4 * random.nextDouble())));
            changes += i > 60 && scale.divisor() != before ? 1 : 0;
        }
        // There and back once in two seconds of 30 frames at most.
        assertThat(changes).isLessThanOrEqualTo(18);
    }
}
