package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.function.BooleanSupplier;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLoader;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.Environment;

/**
 * What all that one light needs takes, stage by stage, with an empty cache and without a window: makes the profile of docs/viewer.md. Not
 * among the tests: {@code ./sunbeam test -Dtest=OneLightRun}, with {@code -Dsunbeam.scene=NAME}. Java optimises here, as in {@code render};
 * {@code SUNBEAM_JAVA_OPTIONS} does not reach tests.
 */
@NeedsDisplay
class OneLightRun {
    private static final int WIDTH = 870;
    private static final int HEIGHT = 811;
    private static final int SAMPLES = 2;
    private static final long MOST_SECONDS = 300;

    @TempDir
    private Path home;

    private long before = System.nanoTime();

    @Test
    void printTimes() throws InterruptedException {
        Scene scene = Scenes.load(System.getProperty("sunbeam.scene", "elaphe"));
        SceneLoader loader = new SceneLoader(new Environment(Map.of(), home), line -> {});
        LoadedScene loaded = LoadedScene.load(loader, scene, null);
        try (RenderContext context = RenderContexts.offscreen();
                SceneSession session = new SceneSession(context, loaded.fine())) {
            print("scene, patch and plan");
            session.bakeInBackground(false, () -> {});
            await(session, session::canMoveCoarsely);
            print("coarsest level");
            session.request(WIDTH, HEIGHT, SAMPLES, () -> false);
            print("where pixels look");
            await(session, () -> session.requestedShare() == 1);
            print("colours");
            session.draw(SAMPLES * WIDTH, SAMPLES * HEIGHT);
            print("drawing");
        }
    }

    private void print(String stage) {
        long now = System.nanoTime();
        System.out.printf(Locale.ROOT, "%s: %.1f s%n", stage, (now - before) * 1e-9);
        before = now;
    }

    private static void await(SceneSession session, BooleanSupplier there) throws InterruptedException {
        long end = System.nanoTime() + MOST_SECONDS * 1_000_000_000L;
        while (!there.getAsBoolean() && System.nanoTime() < end) {
            Thread.sleep(10);
            session.takeBaked();
        }
        assertThat(there.getAsBoolean()).isTrue();
    }
}
