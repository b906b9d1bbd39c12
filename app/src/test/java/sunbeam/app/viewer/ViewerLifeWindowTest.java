package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.JLabel;
import javax.swing.JTextField;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.Main;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.viewer.FileActions.RecentFiles;
import sunbeam.app.viewer.ViewMeasurement.StartJournal;
import sunbeam.app.viewer.loop.GraphicsStage;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** The panel, failures and the end of a viewer in a real window, also while work is running. */
@Tag("window")
final class ViewerLifeWindowTest extends ViewerInAWindow {
    @Test
    void withoutOpenGLALabelSaysWhy() throws Exception {
        Viewer blind = start(
                (next, previous, progress) -> null,
                () -> {
                    throw new GraphicsException("no OpenGL 3.3 here");
                },
                () -> null);
        assertThatThrownBy(() -> new BackgroundTask<>(blind.presenter.firstPicture).get())
                .hasMessageContaining("no OpenGL 3.3 here");
        onEvents(() -> {
            JLabel label = (JLabel) blind.window.picture.getComponent(0);
            assertThat(label.isVisible()).isTrue();
            assertThat(label.getText()).contains("no OpenGL 3.3 here");
            assertThat(Dialogs.all(blind.window.status, JLabel.class))
                    .extracting(JLabel::getText)
                    .contains("No picture of this scene");
            blind.quit();
        });
        blind.awaitEnd(PATIENCE_MILLISECONDS);
    }

    @Test
    void theBodyIsOnScreenBeforeThePatchIsLoaded() throws Exception {
        SceneLoader loader = new SceneLoader(environment(), line -> {});
        BackgroundTask<SceneShape> shape = BackgroundTask.start(() -> loader.shape(scene()));
        CompletableFuture<Void> patchMayLoad = new CompletableFuture<>();
        Viewer early = start(
                (next, previous, progress) -> {
                    patchMayLoad.join();
                    return LoadedScene.load(loader, next, shape);
                },
                GraphicsStage::new,
                shape::get);
        PictureView view = early.window.picture;
        awaitOnEvents(() -> view.picture().isPresent());
        int[] body = onEvents(() -> Pictures.pixels(view.picture().orElseThrow()));
        // The white cylinder before the background, both of one color each but for the shading.
        assertThat(Arrays.stream(body).distinct().count()).isGreaterThan(8);
        assertThat(early.model.loaded()).isEmpty();
        patchMayLoad.complete(null);
        awaitOnEvents(() -> early.presenter.finished().isPresent());
        onEvents(early::quit);
        early.awaitEnd(PATIENCE_MILLISECONDS);
    }

    private Viewer start(ViewerModel.Loading loading, Supplier<GraphicsStage> opening, Supplier<SceneShape> shape)
            throws Exception {
        return onEvents(() -> {
            Viewer made = new Viewer(scene(), loading, opening, new StartJournal(), RecentFiles.of(environment()));
            made.start(new Dimension(80, 60), shape);
            return made;
        });
    }

    @Test
    void methodsAreChosenInThePanelAndOneThatCannotBeUsedIsRefused() throws Exception {
        BufferedImage full = picture();
        for (String label : List.of("nmm", "pq, linear", "gem")) {
            choose("method", label);
            await(() -> MethodChoice.of(loaded().scene()).toString().equals(label));
            awaitFinal();
        }
        assertThat(different(full, picture(), false)).as("gem is another model").isPositive();
        assertThat(modelScene().get(SceneSettings.DIFFRACTION)).isEqualTo(0.5);
        choose("method", "full");
        assertThat(modelScene().weights()).as("as it was before gem").isEqualTo(scene().weights());
        choose("method", "gem");
        onEvents(() -> {
            JTextField spacing = control("spacing", JTextField.class);
            spacing.setText("2 parsec");
            spacing.postActionEvent();
        });
        assertThat(message()).contains("Lines \"2 parsec\" has the unknown unit");
    }

    @Test
    void closedDuringAComputationItEndsAtTheNextTile() throws Exception {
        onEvents(() -> {
            viewer.model.change(ViewerLifeWindowTest::costly);
            viewer.window.setSize(1100, 800);
        });
        await(() -> loaded().suits(modelScene())
                && onEvents(() -> viewer.presenter.finished().isEmpty()));
        onEvents(() -> viewer.window.dispatchEvent(new WindowEvent(viewer.window, WindowEvent.WINDOW_CLOSING)));
        assertThat(viewer.awaitEnd(PATIENCE_MILLISECONDS)).isTrue();
    }

    @Test
    void whatWasToBeSavedIsSavedBeforeTheEnd() throws Exception {
        Path picture = folder.resolve("picture.png");
        onEvents(() -> {
            viewer.files.savePicture(picture);
            viewer.quit();
        });
        assertThat(viewer.awaitEnd(PATIENCE_MILLISECONDS)).isTrue();
        assertThat(message()).doesNotContainIgnoringCase("cannot").doesNotContain("bug");
        assertThat(different(ImageIO.read(picture.toFile()), picture(), false)).isZero();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theProcessEndsWithoutAWordWhenItsWindowIsClosedAtOnceOrDuringAComputation(boolean hasPicture)
            throws Exception {
        Path scene = folder.resolve("scene.json");
        SceneWriter.write(scene, Overwrite.REFUSE, costly(scene()));
        Path out = folder.resolve("out");
        ProcessBuilder builder = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                "-Djava.awt.headless=false",
                ClosedSoon.class.getName(),
                scene.toString(),
                String.valueOf(hasPicture));
        builder.environment().putAll(Map.of("XDG_CACHE_HOME", folder.toString()));
        Process process =
                builder.redirectErrorStream(true).redirectOutput(out.toFile()).start();
        try {
            assertThat(process.waitFor(PATIENCE_MILLISECONDS, TimeUnit.MILLISECONDS))
                    .as("has ended")
                    .isTrue();
        } finally {
            process.destroyForcibly();
        }
        assertThat(Files.readString(out)).isEqualTo(ClosedSoon.CLOSING + System.lineSeparator());
        assertThat(process.exitValue()).isZero();
    }

    private static Scene costly(Scene scene) {
        return scene.with(Choices.none().with(MethodSettings.TOLERANCE, 1e-3));
    }

    /** The program with a thread that closes the window before the first picture or during its refinement. */
    static final class ClosedSoon {
        static final String CLOSING = "closing";

        private ClosedSoon() {}

        public static void main(String[] arguments) {
            boolean hasPicture = Boolean.parseBoolean(arguments[1]);
            Thread closer = new Thread(() -> close(hasPicture), "closer");
            closer.setDaemon(true);
            closer.start();
            Main.main(List.of("view", arguments[0]).toArray(String[]::new));
        }

        private static void close(boolean hasPicture) {
            try {
                awaitOnEvents(() -> {
                    for (Window window : Window.getWindows()) {
                        if (window instanceof ViewerWindow viewer
                                && viewer.isShowing()
                                && viewer.picture.picture().isPresent() == hasPicture) {
                            System.out.println(CLOSING);
                            viewer.dispatchEvent(new WindowEvent(viewer, WindowEvent.WINDOW_CLOSING));
                            return true;
                        }
                    }
                    return false;
                });
            } catch (Exception failure) {
                throw new IllegalStateException(failure);
            }
        }
    }
}
