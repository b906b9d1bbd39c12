package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.render.InAScene;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.viewer.loop.Stage.MapRequest;
import sunbeam.app.viewer.loop.Stage.ViewState;
import sunbeam.app.viewer.loop.StageSessions.FrameScale;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;

/** Pictures of one state, from the first preview to the final one; size and exposure of moving ones. */
class GraphicsStageTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;
    private static final double TENTH_OF_A_STOP = Math.pow(2, 0.1);

    @TempDir
    private Path folder;

    @Test
    @NeedsDisplay
    void aStillPictureKeepsItsBrightnessFromItsFirstColorsToItsLastTile() throws InterruptedException {
        try (GraphicsStage stage = new GraphicsStage()) {
            updateToCoarsest(stage);

            Stage.Preview first = stage.byTiles().orElseThrow();
            assertThat(first.hasColors()).isTrue();
            assertThat(stage.request(() -> false)).isTrue();
            await(stage, () -> stage.requestedShare() == 1);
            Stage.Preview finer = stage.byTiles().orElseThrow();
            Stage.Final last =
                    stage.refine(() -> false, (tile, part, share) -> {}).orElseThrow();

            assertThat(finer.exposure()).isEqualTo(first.exposure());
            assertThat(last.exposure()).isEqualTo(first.exposure());
            double light = light(first.image());
            // A tenth of a stop is hardly visible; a coarser level blurs colors but keeps their mean.
            assertThat(light(finer.image())).isBetween(light / TENTH_OF_A_STOP, light * TENTH_OF_A_STOP);
            assertThat(light(last.image())).isBetween(light / TENTH_OF_A_STOP, light * TENTH_OF_A_STOP);
        }
    }

    @Test
    @NeedsDisplay
    void aPreviewOfTheMapIsNotDrawnAgainForTheSameLightNorForAnotherPatch() throws InterruptedException {
        List<Integer> drawn = new ArrayList<>();
        try (GraphicsStage stage = new GraphicsStage()) {
            Patch patch = updateToCoarsest(stage).firstPart().patch();
            stage.interactive(true);
            for (int theta : new int[] {0, 0, 30}) {
                Thread.sleep(101); // they are drawn ten times a second at most
                MapRequest request = new MapRequest(Direction.ofDegrees(theta, 0), 0, 0, patch);
                stage.map(request, false, () -> false, (image, isFinal) -> drawn.add(theta));
            }
            Thread.sleep(101);
            Patch another = patch.named("another", "");
            MapRequest request = new MapRequest(Direction.ofDegrees(60, 0), 0, 0, another);
            stage.map(request, false, () -> false, (image, isFinal) -> drawn.add(60));
        }
        assertThat(drawn).containsExactly(0, 30);
    }

    @Test
    @NeedsDisplay
    @Timeout(60) // instead of waiting forever for a map that is not drawn
    void theMapAtRestIsDrawnFromTheTablesAtOnceAndEndsWhileTheComparisonIsDrawn() throws InterruptedException {
        List<Boolean> drawn = new CopyOnWriteArrayList<>();
        try (GraphicsStage stage = new GraphicsStage()) {
            LoadedScene loaded = updateToCoarsest(stage);
            stage.update(new ViewState(loaded, 0, WIDTH, HEIGHT, true), () -> {});
            stage.interactive(true);
            Patch patch = loaded.firstPart().patch();
            MapRequest request = new MapRequest(Direction.ofDegrees(30, 0), 0, 0, patch);
            stage.map(request, true, () -> false, (image, isFinal) -> drawn.add(isFinal));
            assertThat(drawn).startsWith(false);
            await(stage, () -> drawn.contains(true));
        }
        assertThat(drawn).containsExactly(false, true);
    }

    private LoadedScene updateToCoarsest(GraphicsStage stage) throws InterruptedException {
        Scene scene = ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(2)));
        LoadedScene loaded = new LoadedScene(InAScene.parts(scene, folder));
        stage.update(new ViewState(loaded, 0, WIDTH, HEIGHT, false), () -> {});
        await(stage, () -> stage.coarsestShare() == 1);
        return loaded;
    }

    private static void await(GraphicsStage stage, BooleanSupplier done) throws InterruptedException {
        while (!done.getAsBoolean()) {
            stage.takeTiles();
            Thread.sleep(5);
        }
    }

    private static double light(BufferedImage image) {
        return IntStream.range(0, WIDTH * HEIGHT)
                .mapToDouble(i -> Srgb.linear(image.getRGB(i % WIDTH, i / WIDTH) >> 8 & 0xff))
                .average()
                .orElseThrow();
    }

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
