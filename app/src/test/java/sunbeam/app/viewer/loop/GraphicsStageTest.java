package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.render.InAScene;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.viewer.loop.Stage.MapRequest;
import sunbeam.app.viewer.loop.Stage.ViewState;
import sunbeam.app.viewer.loop.StageSessions.FrameScale;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.DisplayTransform.Tone;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
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
    void aPreviewOfTheMapIsNotDrawnAgainForTheSameLight() throws InterruptedException {
        List<Integer> drawn = new ArrayList<>();
        try (GraphicsStage stage = new GraphicsStage()) {
            updateToCoarsest(stage);
            stage.interactive(true);
            for (int theta : new int[] {0, 0, 30}) {
                Thread.sleep(101); // they are drawn ten times a second at most
                MapRequest request = new MapRequest(Direction.ofDegrees(theta, 0), 0, 0);
                stage.map(request, false, () -> false, (image, isFinal) -> drawn.add(theta));
            }
        }
        assertThat(drawn).containsExactly(0, 30);
    }

    private void updateToCoarsest(GraphicsStage stage) throws InterruptedException {
        Scene scene = ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(2)));
        LoadedScene loaded = new LoadedScene(InAScene.parts(scene, folder));
        stage.update(new ViewState(loaded, WIDTH, HEIGHT, false), () -> {});
        await(stage, () -> stage.coarsestShare() == 1);
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

    private static final int SIDE = 80;
    private static final int BACKGROUND = 0x101418;

    /** Returns a picture with grays of three decades on one half, nothing on the other. */
    private static LinearPicture picture() {
        SplittableRandom random = new SplittableRandom(7);
        float[] xyz = new float[3 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            double luminance = Math.pow(10, 3 * random.nextDouble() - 2);
            xyz[3 * i] = i % 2 == 0 ? Float.NaN : (float) (0.95047 * luminance);
            xyz[3 * i + 1] = i % 2 == 0 ? Float.NaN : (float) luminance;
            xyz[3 * i + 2] = i % 2 == 0 ? Float.NaN : (float) (1.08883 * luminance);
        }
        return new LinearPicture(SIDE, SIDE, xyz);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.1, 0.3})
    void itIsThatOfTheLightThatIsShown(double exposure) {
        DisplayTransform display = new DisplayTransform(exposure, Tone.COMPRESS);
        BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        image.createGraphics().drawImage(picture().shown(display), 0, 0, null);
        for (int i = 0; i < SIDE * SIDE; i += 2) {
            image.setRGB(i % SIDE, Math.floorDiv(i, SIDE), BACKGROUND);
        }
        // Half a step of 8 bits is 2 % of the light of a pixel ten times as bright as white, which is compressed.
        double exact = LinearPicture.exposure(picture());
        assertThat(CachedExposure.onScreen(image, display, BACKGROUND)).isCloseTo(exact, within(0.02 * exact));
    }
}
