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
import org.joml.Vector3f;
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
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.ScenePreview;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.SkinIndex;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.setting.Choices;

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
    private volatile BufferedImage previewed;
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
            previewed = image;
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
    void aPickKeepsThePictureAndDrawsAnotherMap() throws InterruptedException {
        loop.show(state);
        for (String expected : new String[] {"preview", "map", "complete", "final map"}) {
            assertThat(next()).isEqualTo(expected);
        }
        BufferedImage before = completed;

        loop.show(picked(50));

        assertThat(next()).as("no preview").isEqualTo("complete");
        assertThat(completed).isSameAs(before);
        assertThat(next()).isEqualTo("map");
        assertThat(next()).isEqualTo("final map");
    }

    @Test
    void aPickWhileThePictureIsRefinedLetsItGoOn() throws InterruptedException {
        atFirstTile = () -> loop.show(picked(50));
        loop.show(state);
        assertThat(next()).isEqualTo("preview");
        assertThat(next()).isEqualTo("map");
        assertThat(next()).as("of the picked point").isEqualTo("map");
        assertThat(next()).isEqualTo("complete");
        assertThat(next()).isEqualTo("final map");
        assertThat(heard.poll(300, TimeUnit.MILLISECONDS))
                .as("nothing is drawn twice")
                .isNull();
    }

    @Test
    void anotherPictureAfterAPickIsDrawn() throws InterruptedException {
        loop.show(state);
        for (String expected : new String[] {"preview", "map", "complete", "final map"}) {
            assertThat(next()).isEqualTo(expected);
        }
        loop.show(new ViewState(
                state.parts(), state.coarse(), state.moving(), state.mapped(), WIDTH / 2, HEIGHT, state.mapLight()));
        assertThat(next()).isEqualTo("preview");
    }

    @Test
    void colorsThatAPictureLacksAreMadeInTheBackgroundUntilItIsWhole() throws InterruptedException {
        SceneLoader loader = new SceneLoader(new Environment(Map.of(), folder), warning -> {});
        Scene scene = ViewerInAWindow.scene();
        Choices table = Choices.none().with(Methods.METHOD, TableMethod.TYPE);
        Scene tabulated = scene.withMethod(scene.method().with(table));
        LoadedScene first = LoadedScene.load(loader, tabulated, null);
        assertThat(first.hasMap()).as("left for when there is a picture").isFalse();
        LoadedScene loaded = LoadedScene.load(loader, tabulated, first);
        loop.show(new ViewState(
                loaded.parts(), loaded.coarse(), loaded.moving(), loaded.mapped(), WIDTH, HEIGHT, state.mapLight()));
        assertThat(next()).isEqualTo("preview");
        String said = next();
        boolean waited = false;
        while (said.equals("waiting") || said.equals("preview") || said.equals("map")) {
            waited |= said.equals("waiting");
            said = next();
        }
        assertThat(waited).as("says that colors are being made").isTrue();
        assertThat(said).isEqualTo("complete");
        assertThat(next()).isEqualTo("final map");
        assertShownAsRendered(loaded);

        // Its colors are there: what moves is drawn by them, in full size where there is time, and is nearly what
        // stands still.
        SceneLight light = new SceneLight(new Vector3f(0.32f, -0.62f, -0.4f), 1);
        LoadedScene moved = loaded.with(tabulated.withLight(light));
        loop.show(new ViewState(
                moved.parts(), moved.coarse(), moved.moving(), moved.mapped(), WIDTH, HEIGHT, state.mapLight()));
        assertThat(next()).isEqualTo("preview");
        assertThat(previewed.getWidth())
                .as("of 64: a preview by full would be first 1:16")
                .isGreaterThan(WIDTH / 4);
        while (!next().equals("complete")) {
            // waits for what came into view
        }
        int[] moving = pixels(enlarged(previewed));
        int[] still = pixels(completed);
        double sum = 0;
        for (int i = 0; i < still.length; i++) {
            sum += Math.abs((moving[i] >> 8 & 0xff) - (still[i] >> 8 & 0xff));
        }
        // Of 255: fewer pixels, fewer looks into colors as coarse as they are there, and at the silhouette no
        // neighbors.
        assertThat(sum / still.length).isLessThan(6);
    }

    private static BufferedImage enlarged(BufferedImage image) {
        BufferedImage full = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        full.createGraphics().drawImage(image, 0, 0, WIDTH, HEIGHT, null);
        return full;
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

    private ViewState picked(double thetaDegrees) {
        return new ViewState(
                state.parts(),
                state.coarse(),
                state.moving(),
                state.mapped(),
                WIDTH,
                HEIGHT,
                Optional.of(Direction.ofDegrees(thetaDegrees, 0)));
    }

    @Test
    void aTaskThatFailsDoesNotKeepTheNextPictureAway() throws InterruptedException {
        loop.submit(stage -> {
            throw new GraphicsException("cannot pick");
        });
        assertThat(next()).isEqualTo("refused: cannot pick");
        loop.show(state);
        assertThat(next()).isEqualTo("preview");
    }

    private String next() throws InterruptedException {
        String said = heard.poll(60, TimeUnit.SECONDS);
        assertThat(said).as("what the render thread says").isNotNull();
        return said;
    }
}
