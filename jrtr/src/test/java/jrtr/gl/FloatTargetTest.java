package jrtr.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.File;
import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import jrtr.Tile;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class FloatTargetTest extends InARendering {
    private static final String COORDINATES = "vec4(gl_FragCoord.xy, -1e30, 1.0 / 3.0)";

    // Drivers weigh neighbors by 8 bits of the distance between them, here 2.
    private static final Offset<Float> HALF_A_STEP = within(2f / 256);

    @Test
    void aTileDrawTouchesItsPixelsOnlyTheTopRowFirst() {
        int width = 17;
        int height = 11;
        Tile tile = new Tile(3, 2, 5, 4);
        ShaderProgram program = rendering.program("", COORDINATES);
        try (FloatTarget target = rendering.target(width, height)) {
            target.clear(Tile.whole(width, height), -7, -7, -7, -7);
            rendering.context.drawFullScreen(program, Map.of(), target, tile);
            float[] pixels = target.read(0);

            for (int row = 0; row < height; row++) {
                for (int column = 0; column < width; column++) {
                    boolean inside = column >= 3 && column < 8 && row >= 2 && row < 6;
                    assertThat(pixels[4 * (row * width + column)])
                            .as("column %d, row %d", column, row)
                            .isEqualTo(inside ? column + 0.5f : -7);
                    assertThat(pixels[4 * (row * width + column) + 1]).isEqualTo(inside ? height - row - 0.5f : -7);
                    assertThat(pixels[4 * (row * width + column) + 2])
                            .as("unclamped")
                            .isEqualTo(inside ? -1e30f : -7);
                    assertThat(pixels[4 * (row * width + column) + 3]).isEqualTo(inside ? 1 / 3f : -7);
                }
            }
            assertThatThrownBy(() -> rendering.context.drawFullScreen(program, Map.of(), target, new Tile(16, 0, 2, 1)))
                    .isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void anImageIsATextureForAnotherTargetButNotForItsOwn() {
        ShaderProgram coordinates = rendering.program("", COORDINATES);
        ShaderProgram copy = rendering.program("uniform sampler2D t;", "texelFetch(t, ivec2(gl_FragCoord.xy), 0)");
        try (FloatTarget source = rendering.target(4, 3)) {
            rendering.draw(coordinates, source, Map.of());
            Map<String, Texture> binding = Map.of("t", source.texture(0));

            assertThat(rendering.drawn(copy, 4, 3, binding)).isEqualTo(source.read(0));
            assertThatThrownBy(() -> rendering.draw(copy, source, binding))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("drawn to and read");
        }
    }

    @Test
    void aPictureOfHalfTheSizeFillsATargetAlongStraightLines() {
        try (FloatTarget half = rendering.target(4, 3);
                FloatTarget whole = rendering.target(7, 5)) {
            rendering.draw(rendering.program("", "vec4(2.0 * gl_FragCoord.xy, 0.0, 1.0)"), half, Map.of());
            whole.fill(half);
            float[] pixels = whole.read(0);
            // Between the middles of pixels; beside them colors stay as they are.
            for (int y = 1; y < 5; y++) {
                for (int x = 1; x < 7; x++) {
                    int pixel = 4 * ((4 - y) * 7 + x);
                    assertThat(pixels[pixel]).isCloseTo(x + 0.5f, HALF_A_STEP);
                    assertThat(pixels[pixel + 1]).isCloseTo(y + 0.5f, HALF_A_STEP);
                }
            }
        }
    }

    @Test
    void depthIsATextureForAnotherTarget() {
        ShaderProgram program =
                rendering.program("uniform sampler2D depths;", "texelFetch(depths, ivec2(gl_FragCoord.xy), 0)");
        try (FloatTarget deep = rendering.context.createFloatTarget("deep", new FloatTarget.Spec(4, 4, 1, true))) {
            deep.clear(Tile.whole(4, 4), 0, 0, 0, 0);
            assertThat(rendering.drawn(program, 4, 4, Map.of("depths", deep.depth()))[0])
                    .isEqualTo(1);
        }
        try (FloatTarget flat = rendering.target(4, 4)) {
            assertThatThrownBy(flat::depth)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("no depth");
        }
    }

    @Test
    void sizesBeyondTheDriversLimitsAreRefused() {
        int side = rendering.context.info().limits().textureSize() + 1;

        assertRefused(() -> rendering.target(side, 1), "needs " + side + " x 1 pixels", "at most");
        assertRefused(
                () -> rendering.context.createFloatTarget("many", new FloatTarget.Spec(1, 1, 1000, false)),
                "1000 images");
        rendering.context.finish();
    }

    @Test
    void otherThreadsAreRefused() throws InterruptedException {
        ExecutorService other = Executors.newSingleThreadExecutor();
        try (Rendering rendering = new Rendering()) {
            FloatTarget target = rendering.target(2, 2);

            assertRefusedByThread(other.submit(() -> rendering.target(2, 2)));
            assertRefusedByThread(other.submit(() -> target.read(0)));
            assertRefusedByThread(other.submit(target::close));
            assertRefusedByThread(other.submit(rendering::close));
            assertThat(target.read(0)).as("still there").hasSize(16);
        } finally {
            other.shutdown();
        }
    }

    private static void assertRefusedByThread(Future<?> call) {
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
