package sunbeam.app.viewer.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.gpu.NeedsDisplay;
import sunbeam.app.render.InAScene;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Motion;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.viewer.ViewerInAWindow;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Exposure of the pictures that the render loop shows while the light goes round, and when it is metered anew. */
@NeedsDisplay
class ExposureTest {
    private static final int STEPS = 3;

    @TempDir
    private Path folder;

    private final List<Double> exposures = new ArrayList<>();
    private final Shown shown = new Shown();
    private long now = 1;

    @Test
    void itStaysWhileTheLightGoesRoundABuiltInScene() throws InterruptedException {
        List<Scene> scenes = new ArrayList<>(Scenes.builtIn().stream()
                .map(Scenes::load)
                .map(ExposureTest::quick)
                .toList());
        scenes.add(ViewerInAWindow.scene()
                .with(Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ROUGHNESS, Math.toRadians(2))));
        try (GraphicsStage stage = new GraphicsStage()) {
            RenderLoop loop = new RenderLoop(() -> stage, news -> news.accept(shown), () -> now);
            for (int i = 0; i < scenes.size(); i++) {
                SceneData data = InAScene.parts(scenes.get(i), folder).get(0);
                double metered = draw(loop, stage, data, i, true);
                exposures.clear();
                for (int step = 1; step <= STEPS; step++) {
                    Scene lit = Motion.LIGHT_SWEEP.at(data.scene(), 2 * Math.PI * step / STEPS);
                    draw(loop, stage, data.with(lit), i, step % 2 == 0);
                }
                assertThat(exposures)
                        .as(data.scene().get(SceneSettings.TITLE))
                        .hasSizeGreaterThan(STEPS)
                        .containsOnly(metered);
            }
        }
    }

    /** The scene without what takes seconds: its patch, occlusion of the sky, random slopes, a table, many lights. */
    private static Scene quick(Scene scene) {
        Choices colors = scene.hasEnvironment()
                ? Choices.none()
                        .with(Methods.METHOD, TableMethod.TYPE)
                        .with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(4))
                : Choices.none().with(Methods.METHOD, FullMethod.TYPE);
        return scene.withPatch(PatchRequest.of("blaze"))
                .with(colors.with(MethodSettings.TOLERANCE, 0.05)
                        .with(MethodSettings.COHERENCE_LENGTH, 15e-6)
                        .with(SceneSettings.GROUND, Optional.empty())
                        .with(SceneSettings.SKY, 0.0)
                        .with(SceneSettings.ROUGHNESS, 0.0)
                        .with(SceneSettings.SHADOWS, false));
    }

    /** Lets the loop draw a preview and, if wanted, all until the final picture; returns the last exposure. */
    private double draw(RenderLoop loop, GraphicsStage stage, SceneData data, int metering, boolean untilFinal)
            throws InterruptedException {
        loop.show(new ViewState(new LoadedScene(List.of(data)), metering, 24, 18, false));
        loop.turn(stage);
        while (untilFinal && loop.phase != RenderLoop.Phase.COMPLETE) {
            assertThat(loop.phase).isNotEqualTo(RenderLoop.Phase.EMPTY);
            Thread.sleep(1); // tiles are baked on another thread
            now += 2 * RenderLoop.STILL_NANOSECONDS;
            loop.turn(stage);
        }
        return exposures.get(exposures.size() - 1);
    }

    private final class Shown implements RenderLoop.Listener {
        @Override
        public void preview(ViewState state, Stage.Preview preview) {
            // Before the first colors a scene is not metered yet.
            if (preview.hasColors()) {
                exposures.add(preview.exposure());
            }
        }

        @Override
        public void complete(RenderLoop.Finished finished) {
            exposures.add(finished.picture().exposure());
        }

        @Override
        public void refused(String message) {
            fail(message);
        }

        @Override
        public void problem(String message) {
            fail(message);
        }

        @Override
        public void failed(String message) {
            fail(message);
        }

        @Override
        public void opened(String renderer) {
            // the loop has no thread
        }

        @Override
        public void body(BufferedImage image) {
            // the scene is loaded before it is shown
        }

        @Override
        public void waiting(double share) {
            // tiles come
        }

        @Override
        public void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
            // the final picture has its exposure
        }
    }
}
