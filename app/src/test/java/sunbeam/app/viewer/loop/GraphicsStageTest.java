package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.Environment;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;

/** Pictures of one state, from the first preview to the final one. */
@NeedsDisplay
class GraphicsStageTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;
    private static final double TENTH_OF_A_STOP = Math.pow(2, 0.1);

    @TempDir
    private Path folder;

    @Test
    void aStillPictureKeepsItsBrightnessFromItsFirstColorsToItsLastTile() throws InterruptedException {
        Scene scene = ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(2)));
        SceneLoader loader =
                new SceneLoader(new Environment(Map.of("XDG_CACHE_HOME", folder + ""), folder), line -> {});
        ViewState state =
                new ViewState(new LoadedScene(loader.parts(scene)), WIDTH, HEIGHT, Optional.empty(), 0, false);
        try (GraphicsStage stage = new GraphicsStage()) {
            stage.update(state, () -> {});
            await(stage, () -> stage.coarsestShare() == 1);

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
}
