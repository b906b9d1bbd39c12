package sunbeam.app.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.InAContext;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** Scenes with relief finer than a pixel, whose tables have few tiles. */
@NeedsDisplay
class ReliefTableTest extends InAContext {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 16;

    @TempDir
    private Path folder;

    private Scene scene;

    @BeforeEach
    void prepare() {
        Scene blaze = PlaneScenes.blaze();
        Choices method = Choices.none().with(Methods.METHOD, TableMethod.TYPE);
        scene = blaze.withMethod(new SceneMethod(method))
                .with(Choices.none().with(SceneSettings.ROUGHNESS, Math.toRadians(9)));
    }

    private SceneSession session() {
        return new SceneSession(context, PlaneScenes.load(scene, folder));
    }

    /** A viewer shows a picture as soon as its own tiles are there; the rest of the table comes later. */
    @Test
    void aPictureWaitsForNoOtherTiles() {
        Deque<Runnable> work = new ArrayDeque<>();
        try (SceneSession session = session()) {
            VirtualTexture tiles = session.virtualTexture().orElseThrow();
            tiles.bakeOn(work::add, () -> {});
            assertThat(session.request(WIDTH, HEIGHT, 1, () -> false)).isTrue();
            while (tiles.requestedShare() < 1) {
                work.remove().run();
                tiles.drain();
            }
            assertThat(tiles.isComplete()).isFalse();
            session.prepare(SceneSession.parts(session.scene(), WIDTH, HEIGHT, 1));
            float[] waited = WholePicture.of(session, WIDTH, HEIGHT).rgba();
            try (SceneSession whole = session()) {
                whole.prepare(SceneSession.parts(whole.scene(), WIDTH, HEIGHT, 1));
                assertThat(whole.virtualTexture().orElseThrow().isComplete()).isTrue();
                // The same tiles, and so the same bits.
                assertThat(Arrays.equals(
                                waited, WholePicture.of(whole, WIDTH, HEIGHT).rgba()))
                        .isTrue();
            }
        }
    }
}
