package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;

@NeedsDisplay
class OffscreenContextTest {
    @Test
    void otherThreadsAreRefused() throws InterruptedException {
        ExecutorService other = Executors.newSingleThreadExecutor();
        try (Rendering rendering = new Rendering()) {
            FloatTarget target = rendering.target(2, 2);

            assertRefused(other.submit(() -> rendering.target(2, 2)));
            assertRefused(other.submit(() -> target.read(0)));
            assertRefused(other.submit(target::close));
            assertRefused(other.submit(rendering::close));
            assertThat(target.read(0)).as("still there").hasSize(16);
        } finally {
            other.shutdown();
        }
    }

    private static void assertRefused(Future<?> call) {
        assertThatThrownBy(call::get)
                .isInstanceOf(ExecutionException.class)
                .cause()
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("belongs to thread");
    }

    @Test
    void closedResourcesAndContextsAreRefusedAndMayBeClosedAgain() {
        Rendering rendering = new Rendering();
        ShaderProgram program = rendering.program("uniform float x;", "vec4(x)");
        FloatTexture texture =
                rendering.context.createFloatTexture("table", FloatTexture.Spec.flat(1, 1, FloatTexture.Format.R32F));
        FloatTarget target = rendering.target(1, 1);
        target.close();
        target.close();
        assertThatThrownBy(() -> rendering.draw(program, target, Map.of()))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("'test target' is closed");

        rendering.close();
        rendering.close();

        texture.close();
        assertThatThrownBy(rendering.context::finish)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("closed");
        assertThatThrownBy(() -> program.set("x", 1f)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void contextsLeaveNoConnectionsAndFilesBehind() throws IOException {
        RenderContext.offscreen().close();
        long before = openFiles();
        for (int repetition = 0; repetition < 10; repetition++) {
            RenderContext.offscreen().close();
        }

        // Below one for each context; the virtual machine itself may open a few in the meantime.
        assertThat(openFiles() - before).isLessThan(10);
    }

    /** Number of open files on Linux; elsewhere 0, and the test shows only that contexts can be created repeatedly. */
    private static int openFiles() {
        String[] open = new File("/proc/self/fd").list();
        return open == null ? 0 : open.length;
    }
}
