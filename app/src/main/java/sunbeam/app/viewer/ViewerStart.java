package sunbeam.app.viewer;

import com.formdev.flatlaf.FlatDarkLaf;
import java.awt.AWTError;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import jrtr.GraphicsException;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneLoader.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.viewer.input.KeyControls;
import sunbeam.app.viewer.input.MouseControls;
import sunbeam.app.viewer.loop.GraphicsStage;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.window.RecentFiles;
import sunbeam.app.viewer.window.ViewMeasurement;
import sunbeam.app.viewer.window.ViewMeasurement.StartJournal;
import sunbeam.app.viewer.window.Viewer;
import sunbeam.app.work.BackgroundTask;

/** Starts the viewer: loads a scene and opens its window. */
public final class ViewerStart {
    // Longest wait, after the window closes, for the current tile or file to finish; then the process ends anyway.
    private static final long PATIENCE_MILLISECONDS = 5000;

    // Longest wait for the first final picture before the drags start.
    private static final long LONGEST_WAIT_MILLISECONDS = 180_000;

    private ViewerStart() {}

    /** Shows a scene and waits until its window is closed; without a size of the picture, the window has its own. */
    public static void show(Scene scene, Environment environment, Consumer<String> warning, Dimension pictureSize)
            throws InterruptedException {
        Viewer viewer = open(scene, environment, warning, pictureSize);
        viewer.awaitEnd(PATIENCE_MILLISECONDS);
    }

    /** Shows a scene, drags its light and its model for the given seconds each, closes the window and returns the measurements as text. */
    public static String measure(
            Scene scene, Environment environment, Consumer<String> warning, Dimension pictureSize, double seconds)
            throws InterruptedException {
        Viewer viewer = open(scene, environment, warning, pictureSize);
        try {
            viewer.awaitPicture();
            viewer.awaitFinalByTable(LONGEST_WAIT_MILLISECONDS);
            return viewer.journal().report() + System.lineSeparator() + ViewMeasurement.of(viewer, seconds);
        } finally {
            SwingUtilities.invokeLater(viewer::quit);
            viewer.awaitEnd(PATIENCE_MILLISECONDS);
        }
    }

    static Viewer open(Scene scene, Environment environment, Consumer<String> warning, Dimension pictureSize)
            throws InterruptedException {
        if (GraphicsEnvironment.isHeadless()) {
            throw new GraphicsException("the viewer needs a screen: start it on a desktop, or set DISPLAY");
        }
        StartJournal journal = new StartJournal();
        journal.reached("scene read");
        AtomicReference<Viewer> viewer = new AtomicReference<>();
        SceneLoader loader = new SceneLoader(
                environment,
                line -> {
                    warning.accept(Messages.warning(line));
                    // Messages before the window exists go to the terminal.
                    Optional.ofNullable(viewer.get()).ifPresent(shown -> shown.message(line));
                },
                // Drops remarks about patches: the panel shows them beside the patch's name.
                line -> {});
        // Loads the scene in the background while Swing starts, since Swing's start uses one processor only; first the
        // shape, which is shown before the rest is loaded.
        BackgroundTask<SceneShape> shape = BackgroundTask.start(() -> loader.shape(scene));
        BackgroundTask<LoadedScene> first = shape.then(() -> LoadedScene.load(loader, scene, shape));
        try {
            SwingUtilities.invokeAndWait(() -> {
                FlatDarkLaf.setup();
                viewer.set(new Viewer(
                        scene,
                        (next, previous, progress) -> previous == null && next.equals(scene)
                                ? first.get()
                                : LoadedScene.load(loader, next, previous, progress),
                        GraphicsStage::new,
                        journal,
                        RecentFiles.of(environment)));
                KeyControls.install(viewer.get());
                MouseControls.install(viewer.get());
                viewer.get().start(pictureSize, shape::get);
            });
        } catch (InvocationTargetException failure) {
            throw unchecked(failure.getCause());
        } catch (AWTError | LinkageError failure) {
            throw unchecked(failure);
        }
        return viewer.get();
    }

    /** A display that does not answer, or a Java installation without AWT's screen libraries, has a message. */
    private static RuntimeException unchecked(Throwable failure) {
        if (!(failure instanceof AWTError || failure instanceof LinkageError)) {
            return failure instanceof RuntimeException cause ? cause : new IllegalStateException(failure);
        }
        String why = String.valueOf(failure.getMessage()).strip().replaceAll("\\.$", "");
        return new GraphicsException("the viewer cannot open the screen: " + why
                + "; start it on a desktop, or set DISPLAY to an existing screen");
    }
}
