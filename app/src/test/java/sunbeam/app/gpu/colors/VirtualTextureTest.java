package sunbeam.app.gpu.colors;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import jrtr.gl.RenderContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.Environment;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.precompute.method.LevelBakers;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** A color table whose tiles are baked and one whose tiles are in the cache. */
@NeedsDisplay
class VirtualTextureTest {
    @TempDir
    private Path folder;

    @Test
    void onlyBakedTilesAreValidatedNotTilesFromTheCache() {
        try (CachedBaker baking = new CachedBaker(bakers())) {
            bakeCoarsest(baking);
            // Validation evaluates colors, which a canceled token ends at once.
            assertThatThrownBy(() -> validate(baking)).isInstanceOf(CancellationException.class);
        }
        try (CachedBaker reading = new CachedBaker(bakers())) {
            bakeCoarsest(reading);
            // A BRDF map evaluates points.
            assertThat(reading.evaluate(CachedBaker.POINTS, new float[] {0, 0, -1.9f}, new CancellationToken()))
                    .hasSize(3);
            validate(reading);
        }
    }

    @Test
    void aTableInTheCacheIsRequestedWithoutFootprints() {
        assertThat(isRequestedWhole()).as("before any tile is baked").isFalse();
        try (CachedBaker baking = new CachedBaker(bakers())) {
            baking.bakeAll(CachedBaker.PrefetchSet.of(baking.grids()).prefetched());
        }
        assertThat(isRequestedWhole()).isTrue();
    }

    /** Starts a background table; if its whole is requested, checks that all tiles arrive. */
    private boolean isRequestedWhole() {
        Deque<Runnable> tasks = new ArrayDeque<>();
        boolean isWhole;
        try (RenderContext context = RenderContext.offscreen();
                VirtualTexture texture = new VirtualTexture(context, bakers())) {
            texture.bakeOn(tasks::add, () -> {});
            tasks.remove().run();
            isWhole = texture.requestWhole();
            runAll(tasks);
            assertThat(texture.drain()).isTrue();
            assertThat(texture.isComplete()).isEqualTo(isWhole);
        }
        runAll(tasks);
        return isWhole;
    }

    private static void runAll(Deque<Runnable> tasks) {
        while (!tasks.isEmpty()) {
            tasks.remove().run();
        }
    }

    private LevelBakers bakers() {
        Scene scene = ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(4)));
        SceneLoader loader =
                new SceneLoader(new Environment(Map.of("XDG_CACHE_HOME", folder + ""), folder), line -> {});
        return loader.parts(scene).get(0).bakers().orElseThrow();
    }

    private static void bakeCoarsest(CachedBaker baker) {
        TileSet coarsest = CachedBaker.PrefetchSet.of(baker.grids()).coarsest();
        assertThat(coarsest.isEmpty()).isFalse();
        baker.bakeAll(coarsest);
    }

    private static void validate(CachedBaker baker) {
        int coarsest = baker.grids().size() - 1;
        double[] white = {1, 1, 1};
        Footprints.Sample.BrightFootprint footprint =
                new Footprints.Sample.BrightFootprint(coarsest, new double[][] {{0, 0, -1.9}}, white);
        CancellationToken canceled = new CancellationToken();
        canceled.cancel();
        baker.validate(new Footprints.Sample.Tabulated(baker.table(), List.of(footprint)), canceled);
    }
}
