package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.Window;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.Main;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.viewer.window.ViewerWindow;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Closes windows while work is running. */
@Tag("window")
final class ViewerEndWindowTest extends ViewerInAWindow {
    @Test
    void closedDuringAComputationItEndsAtTheNextTile() throws Exception {
        onEvents(() -> {
            viewer.model().change(ViewerEndWindowTest::costly);
            viewer.window().setSize(1100, 800);
        });
        await(() -> loaded().suits(modelScene()) && !viewer.window().picture().isFinal());
        closeWindow();
        assertEnd();
    }

    @Test
    void closedDuringALoadItEnds() throws Exception {
        Path patch = PatchFiles.descriptor(folder, "waves");
        onEvents(() -> {
            viewer.files().loadPatch(patch);
            viewer.window().dispatchEvent(new WindowEvent(viewer.window(), WindowEvent.WINDOW_CLOSING));
        });
        assertEnd();
    }

    @Test
    void whatWasToBeSavedIsSavedBeforeTheEnd() throws Exception {
        Path picture = folder.resolve("picture.png");
        onEvents(() -> {
            viewer.files().savePicture(picture);
            viewer.quit();
        });
        assertEnd();
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

    /** Asserts that the render thread ends; it ends only after OpenGL is closed. */
    private void assertEnd() throws Exception {
        assertThat(viewer.awaitEnd(PATIENCE_MILLISECONDS)).isTrue();
        assertThat(message()).doesNotContainIgnoringCase("cannot").doesNotContain("bug");
    }

    private static Scene costly(Scene scene) {
        return scene.with(Choices.none().with(MethodSettings.TOLERANCE, 1e-3));
    }

    private void closeWindow() throws Exception {
        onEvents(() -> viewer.window().dispatchEvent(new WindowEvent(viewer.window(), WindowEvent.WINDOW_CLOSING)));
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
                                && viewer.picture().picture().isPresent() == hasPicture
                                && !viewer.picture().isFinal()) {
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
