package sunbeam.app.viewer.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.render.InAScene;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.ViewerInAWindow;

/** The scene that the viewer draws while another one is loaded; it is loaded when the test says so. */
class ViewerModelTest {
    @TempDir
    private Path folder;

    private final Background background = new Background("loading");
    private final CountDownLatch mayLoad = new CountDownLatch(1);
    private final CountDownLatch hasOpened = new CountDownLatch(1);
    private final Scene first = ViewerInAWindow.scene();
    private ViewerModel model;

    @BeforeEach
    void load() throws Exception {
        LoadedScene loaded = new LoadedScene(InAScene.parts(first, folder));
        CountDownLatch isLoaded = new CountDownLatch(1);
        model = new ViewerModel(
                first,
                (scene, previous, progress) -> {
                    if (previous == null) {
                        return loaded;
                    }
                    await(mayLoad);
                    return loaded.with(SceneSharing.withPartsOf(first, scene));
                },
                background);
        model.setListener(new ViewerModel.Listener() {
            @Override
            public void changed() {
                isLoaded.countDown();
            }

            @Override
            public void loading(double share) {
                // not shown
            }

            @Override
            public void problem(String message) {
                throw new AssertionError(message);
            }
        });
        SwingUtilities.invokeAndWait(model::load);
        await(isLoaded);
    }

    private static void await(CountDownLatch latch) {
        try {
            assertThat(latch.await(60, TimeUnit.SECONDS)).isTrue();
        } catch (InterruptedException stopped) {
            throw new AssertionError(stopped);
        }
    }

    @AfterEach
    void close() {
        mayLoad.countDown();
        background.close();
    }

    private static Scene lit(Scene scene) {
        return scene.withLight(new SceneLight(new Vector3f(1, 0, 1).normalize(), 1, 0));
    }

    @Test
    void aSceneThatIsOpenedIsDrawnOnceAllOfItIsLoadedAndMeteredAnew() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            int metered = model.metering();
            model.open(lit(first), hasOpened::countDown);
            assertThat(model.scene()).isEqualTo(lit(first));
            assertThat(model.drawnScene()).as("the old picture stays").isEqualTo(first);
            model.change(scene -> scene.with(SceneSettings.ROTATE_PATCH, 1.0));
            assertThat(model.drawnScene()).as("whatever changes meanwhile").isEqualTo(first);
            assertThat(model.metering()).isEqualTo(metered);
            mayLoad.countDown();
        });
        await(hasOpened);
        SwingUtilities.invokeAndWait(() -> {
            assertThat(model.drawnScene()).isEqualTo(lit(first).with(SceneSettings.ROTATE_PATCH, 1.0));
            assertThat(model.metering()).isPositive();
        });
    }

    @Test
    void theOldPartsFollowDragsWhileOthersAreLoadedButHaveNoOtherWeights() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            model.change(scene -> scene.with(SceneSettings.TEXTURE, "elaphe"));
            model.change(ViewerModelTest::lit);
            assertThat(model.drawnScene()).isEqualTo(lit(first));
            model.change(scene -> scene.with(SceneSettings.DIFFRACTION, 0.5));
            assertThat(model.drawnScene().get(SceneSettings.DIFFRACTION))
                    .isEqualTo(first.get(SceneSettings.DIFFRACTION));
        });
    }

    @Test
    void meteringMakesTheExposureAutomatic() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            model.change(scene -> scene.with(SceneSettings.EXPOSURE, OptionalDouble.of(2)));
            int before = model.metering();
            model.meter();
            assertThat(model.scene()).isEqualTo(first);
            assertThat(model.metering()).isGreaterThan(before);
        });
    }
}
