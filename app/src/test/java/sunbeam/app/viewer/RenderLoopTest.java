package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import jrtr.ContextInfo;
import jrtr.GraphicsException;
import jrtr.RenderContext;
import jrtr.Tile;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.PixelSamples;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.ScenePreview;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.SkinIndex;
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
    private volatile BufferedImage completed;
    private volatile Runnable atFirstTile = () -> {};
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
            completed = image;
            heard.add("complete");
        }

        @Override
        public void tile(ViewState shown, BufferedImage image, int x, int y, double shareDone) {
            Runnable once = atFirstTile;
            atFirstTile = () -> {};
            once.run();
        }

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

    @Test
    void aSkinWithAnIndexByWavelengthIsDrawnAsRenderDrawsIt() throws InterruptedException, IOException {
        loop.show(state);
        while (!next().equals("final map")) {
            // a skin with one index, before
        }
        BufferedImage keratin = completed;
        Path copper = Files.writeString(
                folder.resolve("copper.csv"), "wl,n,k\n0.38,1.2,2.2\n0.55,1.0,2.6\n0.6,0.3,3.3\n0.8,0.25,5\n");
        SceneLoader loader = new SceneLoader(new Environment(Map.of(), folder), warning -> {});
        Scene scene = ViewerInAWindow.scene().withIndex(SkinIndex.of(copper.toString()));
        LoadedScene loaded = LoadedScene.load(loader, scene, null);
        assertThat(loaded.parts()).hasSize(2);
        for (LoadedScene shown : List.of(loaded, LoadedScene.load(loader, scene, loaded))) {
            loop.show(new ViewState(
                    shown.parts(), shown.coarse(), shown.moving(), shown.mapped(), WIDTH, HEIGHT, state.mapLight()));
            while (!next().equals("final map")) {
                // previews and the map
            }
            assertShownAsRendered(shown);
            assertThat(pixels(completed)).isNotEqualTo(pixels(keratin));
        }
        loop.show(state);
        while (!next().equals("final map")) {
            // and back
        }
        assertThat(pixels(completed)).isEqualTo(pixels(keratin));
    }

    private void assertShownAsRendered(LoadedScene loaded) {
        Scene scene = loaded.fine().scene();
        List<SceneSession> sessions = new ArrayList<>();
        try (RenderContext context = RenderContexts.offscreen()) {
            loaded.parts().forEach(part -> sessions.add(new SceneSession(context, part)));
            PartSum sum = new PartSum(sessions);
            int samples = PixelSamples.alongSide(scene.method(), WIDTH, HEIGHT);
            double exposure = SceneDisplay.exposure(scene, sum, WIDTH, HEIGHT);
            sum.prepare(scene, WIDTH, HEIGHT, samples);
            ScenePicture picture = sum.samples(scene, WIDTH, HEIGHT, Tile.whole(WIDTH, HEIGHT), samples);
            BufferedImage rendered = SceneDisplay.image(picture, samples, scene.display(exposure), scene.background());
            sessions.forEach(SceneSession::close);
            assertThat(pixels(completed)).isEqualTo(pixels(rendered));
        }
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
    }

    private String next() throws InterruptedException {
        String said = heard.poll(60, TimeUnit.SECONDS);
        assertThat(said).as("what the render thread says").isNotNull();
        return said;
    }
}
