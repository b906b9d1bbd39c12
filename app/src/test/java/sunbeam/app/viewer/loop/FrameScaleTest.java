package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Frame times consist of a time for the mesh and a time per pixel. */
final class FrameScaleTest {
    private static final int FRAMES = 300;

    private static long taken(double fixed, double pixels, double divisor) {
        return (long) (1e6 * (fixed + pixels / divisor / divisor));
    }

    @ParameterizedTest
    @CsvSource({"5, 20, 1", "20, 10, 1", "5, 40, 1.25", "5, 60, 1.6", "5, 90, 2", "12, 160, 3", "5, 4000, 4"})
    void mostFramesHaveTheFinestScaleThatKeepsToTheBudget(double fixed, double pixels, double divisor) {
        FrameScale scale = new FrameScale();
        DoubleStream drawn = IntStream.range(0, FRAMES).mapToDouble(frame -> {
            double now = scale.divisor();
            scale.frame(taken(fixed, pixels, now));
            return now;
        });
        assertThat(drawn.filter(now -> now == divisor).count()).isGreaterThan(FRAMES * 3 / 4);
    }

    @Test
    void framesThatWereHeldUpAreForgottenWithinSeconds() {
        FrameScale scale = new FrameScale();
        for (int frame = 0; frame < 4; frame++) {
            scale.frame(200_000_000);
        }
        assertThat(scale.divisor()).isGreaterThan(1);
        for (int frame = 0; frame < 100; frame++) {
            scale.frame(taken(12, 16, scale.divisor()));
        }
        assertThat(scale.divisor()).isEqualTo(1);
    }
}
