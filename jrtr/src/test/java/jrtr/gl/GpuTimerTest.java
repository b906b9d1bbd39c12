package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jrtr.FloatTarget;
import jrtr.GpuTime;
import jrtr.GpuTime.Source;
import jrtr.GpuTimer;
import jrtr.ShaderProgram;
import org.junit.jupiter.api.Test;

@NeedsDisplay
class GpuTimerTest {

    @Test
    void timeIsPositiveAndNotAboveTheWallClocks() {
        try (Rendering rendering = new Rendering();
                GpuTimer timer = rendering.context.createTimer();
                FloatTarget target = rendering.target(64, 64)) {
            ShaderProgram program = rendering.program("", "vec4(sin(gl_FragCoord.x))");

            long start = System.nanoTime();
            GpuTime time = timer.measure(() -> rendering.draw(program, target));
            long wall = System.nanoTime() - start;

            assertThat(time.nanoseconds()).isPositive().isLessThanOrEqualTo(wall);
            if (rendering.context.info().software()) {
                assertThat(time.source()).isEqualTo(Source.WALL_CLOCK);
            }
            assertThat(time.seconds()).isEqualTo(time.nanoseconds() * 1e-9);
        }
    }

    @Test
    void nestedMeasurementsAreRefusedAndLeaveTheTimerUsable() {
        try (Rendering rendering = new Rendering();
                GpuTimer timer = rendering.context.createTimer()) {
            assertThatThrownBy(() -> timer.measure(() -> timer.measure(() -> {})))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("do not nest");
            assertThat(timer.measure(() -> {}).nanoseconds()).isPositive();
        }
    }

    @Test
    void impossibleAnswersOfTheDriverAreReplacedByTheWallClocks() {
        assertThat(GlTimer.decide(500, 1000)).isEqualTo(new GpuTime(500, Source.TIMER_QUERY));
        assertThat(GlTimer.decide(0, 1000)).isEqualTo(new GpuTime(1000, Source.WALL_CLOCK));
        assertThat(GlTimer.decide(-1, 1000)).isEqualTo(new GpuTime(1000, Source.WALL_CLOCK));
        assertThat(GlTimer.decide(1001, 1000)).isEqualTo(new GpuTime(1000, Source.WALL_CLOCK));
    }
}
