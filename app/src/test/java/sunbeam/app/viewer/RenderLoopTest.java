package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import jrtr.ContextInfo;
import jrtr.GraphicsException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.ScenePreview;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.optics.Direction;

/** A render thread, with real OpenGL but no window, that lives on when something cannot be drawn. */
@NeedsDisplay
@Timeout(120)
class RenderLoopTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;

    @TempDir
    private Path folder;

    private final BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    private final AtomicReference<Throwable> mapFailure = new AtomicReference<>();
    private final AtomicReference<Throwable> previewFailure = new AtomicReference<>();
    private RenderLoop loop;
    private ViewState state;

    /** Fails where it is told to, as a full heap or a full graphics card does. */
    private final class FailingStage extends GraphicsStage {
        @Override
        BufferedImage map(Direction light, int size, BooleanSupplier interrupted) {
            fail(mapFailure.getAndSet(null));
            return super.map(light, size, interrupted);
        }

        @Override
        ScenePreview preview(int width, int height, int divisor) {
            fail(previewFailure.getAndSet(null));
            return super.preview(width, height, divisor);
        }

        private static void fail(Throwable failure) {
            if (failure instanceof Error error) {
                throw error;
            }
            if (failure instanceof RuntimeException exception) {
                throw exception;
            }
        }
    }

    private final class Listener implements RenderListener {
        @Override
        public void opened(ContextInfo info) {}

        @Override
        public void failed(String message) {
            heard.add("failed: " + message);
        }

        @Override
        public void refused(String message) {
            heard.add("refused: " + message);
        }

        @Override
        public void preview(
                ViewState shown, BufferedImage image, int divisor, boolean tables, double exposure, long nanoseconds) {
            heard.add("preview");
        }

        @Override
        public void waiting(double share) {
            heard.add("waiting");
        }

        @Override
        public void complete(ViewState shown, BufferedImage image, double exposure, long nanoseconds) {
            heard.add("complete");
        }

        @Override
        public void tile(ViewState shown, BufferedImage image, int x, int y, double shareDone) {}

        @Override
        public void map(ViewState shown, BufferedImage image, boolean isFinal) {
            heard.add(isFinal ? "final map" : "map");
        }
    }

    @BeforeEach
    void start() {
        SceneLoader loader = new SceneLoader(new Environment(Map.of(), folder), warning -> {});
        LoadedScene loaded = LoadedScene.load(loader, ViewerInAWindow.scene(), null);
        state = new ViewState(
                loaded.parts(),
                loaded.coarse(),
                loaded.moving(),
                loaded.mapped(),
                WIDTH,
                HEIGHT,
                Optional.of(Direction.ofDegrees(30, 0)));
        loop = new RenderLoop(FailingStage::new, new Listener(), Runnable::run);
        loop.start();
    }

    @AfterEach
    void end() throws InterruptedException {
        loop.close();
        assertThat(loop.awaitEnd(60_000)).isTrue();
    }

    @Test
    void aMapThatFindsNoMemoryIsLeftOutAndAllElseIsDrawn() throws InterruptedException {
        mapFailure.set(new OutOfMemoryError("Java heap space"));
        loop.show(state);
        assertThat(next()).isEqualTo("preview");
        assertThat(next()).startsWith("refused: out of memory").contains("-Xmx");
        assertThat(next()).isEqualTo("complete");
        assertThat(next()).isEqualTo("final map");
    }

    @Test
    void aPictureThatCannotBeDrawnIsRefusedAndTheNextOneComes() throws InterruptedException {
        previewFailure.set(new GraphicsException("the graphics card is full"));
        loop.show(state);
        assertThat(next()).isEqualTo("refused: the graphics card is full");
        loop.show(state);
        assertThat(next()).isEqualTo("preview");
        assertThat(next()).isEqualTo("map");
        assertThat(next()).isEqualTo("complete");
        assertThat(next()).isEqualTo("final map");
    }

    private String next() throws InterruptedException {
        String said = heard.poll(60, TimeUnit.SECONDS);
        assertThat(said).as("what the render thread says").isNotNull();
        return said;
    }
}
