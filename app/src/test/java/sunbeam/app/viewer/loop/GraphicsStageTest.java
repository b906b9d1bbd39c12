package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.render.InAScene;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneSession;
import sunbeam.app.scene.Placement;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneObject;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.terminal.Environment;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.viewer.loop.Stage.MapRequest;
import sunbeam.app.viewer.loop.StageSessions.FrameScale;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Pictures of one state, from the first preview to the final one; size and exposure of moving ones. */
class GraphicsStageTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;
    private static final double TENTH_OF_A_STOP = Math.pow(2, 0.1);
    private static final double A_STOP = 2;

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
    void whileTilesArriveAPictureAtRestReadsAllOfALevelOrNothing() throws InterruptedException {
        try (GraphicsStage stage = new GraphicsStage()) {
            LoadedScene loaded = updateToCoarsest(stage);
            int[] coarse = pixels(stage.byTiles().orElseThrow());
            // Lights come nearer until a third of the tiles are resident.
            Scene scene = loaded.firstPart().scene();
            double share = 0;
            for (float aside = 1; share < 0.3; aside -= 0.05f) {
                makeResident(
                        stage,
                        loaded.with(scene.withLight(scene.light().pointing(new Vector3f(aside, -0.6f, -0.42f)))));
                show(stage, loaded);
                assertThat(stage.request(() -> false)).isTrue();
                share = stage.requestedShare();
            }
            int[] patchy = pixels(stage.moving(() -> false).orElseThrow());
            int[] still = pixels(stage.byTiles().orElseThrow());
            makeResident(stage, loaded);
            int[] fine = pixels(stage.moving(() -> false).orElseThrow());
            int few = WIDTH * HEIGHT / 100; // in which nobody sees an edge
            assertThat(different(patchy, coarse)).as("tiles").isGreaterThan(few);
            assertThat(different(patchy, fine)).as("gaps").isGreaterThan(few);
            assertThat(different(still, coarse)).isLessThanOrEqualTo(few);
        }
    }

    private static void makeResident(GraphicsStage stage, LoadedScene loaded) throws InterruptedException {
        show(stage, loaded);
        assertThat(stage.request(() -> false)).isTrue();
        await(stage, () -> stage.requestedShare() == 1);
    }

    private static long different(int[] one, int[] other) {
        return IntStream.range(0, one.length).filter(i -> one[i] != other[i]).count();
    }

    private static void show(GraphicsStage stage, LoadedScene loaded) {
        stage.update(new ViewState(loaded, 0, WIDTH, HEIGHT, false), () -> {});
    }

    private static int[] pixels(Stage.Preview preview) {
        return preview.image().getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
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

    @Test
    @NeedsDisplay
    void aPictureBeforeItsColorsIsAboutAsBrightAsWithThem() throws InterruptedException {
        // A coarse tolerance for fewer colors; their mean is the same.
        Scene scene = Scenes.load("disc").with(Choices.none().with(MethodSettings.TOLERANCE, 0.1));
        List<SceneData> parts = InAScene.parts(scene, folder);
        try (GraphicsStage stage = new GraphicsStage()) {
            double body = light(stage.body(scene, parts.get(0).shape(), WIDTH, HEIGHT));
            stage.update(new ViewState(new LoadedScene(parts), 0, WIDTH, HEIGHT, false), () -> {});
            Stage.Preview before = stage.moving(() -> false).orElseThrow();
            assertThat(before.hasColors()).isFalse();
            await(stage, () -> stage.coarsestShare() == 1);
            double colors = light(stage.byTiles().orElseThrow().image());
            // A stop at most: the light of orders is not known yet, but for its mean over built-in scenes.
            assertThat(light(before.image())).isBetween(colors / A_STOP, colors * A_STOP);
            assertThat(body).isBetween(colors / A_STOP, colors * A_STOP);
        }
    }

    @Test
    @NeedsDisplay
    void aMovingPictureUnderAnEnvironmentHasAllObjectsAndFewLights() {
        Scene plain = ViewerInAWindow.scene()
                .withMesh(MeshSource.of("sphere"))
                .with(Choices.none()
                        .with(SceneSettings.ENVIRONMENT, "overcast")
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(2))
                        .with(Methods.METHOD, TableMethod.TYPE));
        List<SceneObject> objects = new ArrayList<>();
        for (int side = -1; side <= 1; side += 2) {
            Placement aside =
                    new Placement(new Vector3f(0.05f * side, 0, 0), new Quaternionf(), OptionalDouble.of(0.06));
            Choices own = plain.settings().with(SceneSettings.DIFFRACTION, 1000.0 + side);
            objects.add(new SceneObject(own, plain.patches(), aside));
        }
        LoadedScene loaded = new LoadedScene(InAScene.parts(plain.withObjects(objects), folder));
        try (GraphicsStage stage = new GraphicsStage()) {
            stage.update(new ViewState(loaded, 0, WIDTH, HEIGHT, false), () -> {});
            Stage.Preview moving = stage.moving(() -> false).orElseThrow();

            assertThat(loaded.parts()).as("one for each look").hasSize(2);
            assertThat(moving.lights()).hasValue(SceneSession.MOVING_LIGHTS);
            assertThat(moving.hasColors()).isFalse();
            assertThat(moving.exposure())
                    .as("not metered yet: a white body is white")
                    .isEqualTo(1);
            int dark = green(moving.image(), WIDTH / 2, 0);
            for (int side = 0; side < 2; side++) {
                int left = side * WIDTH / 2;
                assertThat(IntStream.range(0, WIDTH / 2 * HEIGHT)
                                .filter(i -> green(moving.image(), left + i % (WIDTH / 2), i / (WIDTH / 2)) > dark + 20)
                                .count())
                        .isGreaterThan(20);
            }
        }
    }

    @Test
    @NeedsDisplay
    void aSoftShadowHasNoGrainInAMovingPicture() {
        Scene plain = ViewerInAWindow.scene()
                .withMesh(MeshSource.of("sphere"))
                .with(Choices.none().with(SceneSettings.SHADOWS, true))
                .withLight(new SceneLight(new Vector3f(0.4f, -0.5f, 0.77f), 1, Math.toRadians(10)));
        Vector3f towards = plain.light().towards().mul(0.3f, new Vector3f());
        Placement between = new Placement(towards, new Quaternionf(), OptionalDouble.of(0.1));
        List<SceneObject> objects = new ArrayList<>(plain.objects());
        objects.add(new SceneObject(plain.settings(), plain.objects().get(0).patches(), between));
        Scene scene = plain.withObjects(objects);
        try (GraphicsStage stage = new GraphicsStage()) {
            SceneLoader loader = new SceneLoader(new Environment(Map.of(), folder), warning -> {});
            BufferedImage picture = stage.body(scene, loader.shape(scene), 4 * WIDTH, 4 * HEIGHT);
            // Single taps of four have a quarter of the light, 64 levels; smooth shading differs by less than 8.
            assertThat(IntStream.range(0, picture.getWidth() * picture.getHeight())
                            .filter(i -> isLonely(picture, i % picture.getWidth(), i / picture.getWidth(), 8)))
                    .isEmpty();
        }
    }

    /** True if a pixel's green is darker, or brighter, by some levels than that of all its neighbors. */
    private static boolean isLonely(BufferedImage image, int x, int y, int levels) {
        if (x == 0 || y == 0 || x == image.getWidth() - 1 || y == image.getHeight() - 1) {
            return false;
        }
        int own = green(image, x, y);
        int[] around = IntStream.range(0, 9)
                .filter(i -> i != 4)
                .map(i -> green(image, x + i % 3 - 1, y + i / 3 - 1) - own)
                .toArray();
        return Arrays.stream(around).allMatch(step -> step > levels)
                || Arrays.stream(around).allMatch(step -> step < -levels);
    }

    private static int green(BufferedImage image, int x, int y) {
        return image.getRGB(x, y) >> 8 & 0xff;
    }

    private static Scene table() {
        return ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(2)));
    }

    private LoadedScene updateToCoarsest(GraphicsStage stage) throws InterruptedException {
        LoadedScene loaded = new LoadedScene(InAScene.parts(table(), folder));
        show(stage, loaded);
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
