package sunbeam.app.viewer;

import com.formdev.flatlaf.FlatDarkLaf;
import java.awt.AWTError;
import java.awt.AWTEvent;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import jrtr.GraphicsException;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.PlotFont;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.Motion;
import sunbeam.app.scene.Scene;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.Messages;
import sunbeam.app.viewer.FileActions.RecentFiles;
import sunbeam.app.viewer.ViewMeasurement.StartJournal;
import sunbeam.app.viewer.loop.GraphicsStage;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.model.Background;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.patch.Patch;

/** Viewer: creates and connects window, model and render thread. Its instances are used on the event thread only. */
public final class Viewer {
    // Longest wait, after the window closes, for the current tile or file to finish; then the process ends anyway.
    private static final long PATIENCE_MILLISECONDS = 5000;

    // Longest wait for the first final picture before the drags start.
    private static final long LONGEST_WAIT_SECONDS = 180;

    final ViewerModel model;
    final ViewerWindow window;
    final RenderLoop loop;
    final FileActions files;
    final PointInspector inspector;
    final ScenePresenter presenter;
    final PatchPeriods periods = new PatchPeriods(this);
    final InspectionWindow inspections = new InspectionWindow(this);
    final Player player;
    final StartJournal journal;
    final Background loading = new Background("loading");
    final Background writing = new Background("files");
    final Background measuring = new Background("spectrum");
    private final CountDownLatch closed = new CountDownLatch(1);
    private final AWTEventListener dragListener = this::trackDrag;
    Scene sceneAsOpened;
    Optional<Kiosk> kiosk = Optional.empty();
    /** Receives the sentence about the picked point, else about the patch. */
    Consumer<String> caption = sentence -> {};

    Viewer(
            Scene scene,
            ViewerModel.Loading loader,
            Supplier<GraphicsStage> opening,
            StartJournal journal,
            RecentFiles recent) {
        this.journal = journal;
        sceneAsOpened = scene;
        model = new ViewerModel(scene, loader, loading);
        player = new Player(model);
        // OpenGL opens while the window is created; its notifications wait for the event thread.
        loop = new RenderLoop(opening, this::tell, System::nanoTime);
        loop.start();
        try {
            window = new ViewerWindow(ScenePresenter.title(scene), model);
            inspector = new PointInspector(this);
            files = new FileActions(this, recent);
            presenter = new ScenePresenter(this, loader);
            window.controls.comparison.addActionListener(event -> presenter.compare());
            Toolkit.getDefaultToolkit().addAWTEventListener(dragListener, AWTEvent.MOUSE_EVENT_MASK);
            model.setListener(presenter);
            window.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosed(WindowEvent event) {
                    end();
                }
            });
            window.picture.addComponentListener(new ComponentAdapter() {
                @Override
                public void componentResized(ComponentEvent event) {
                    presenter.show();
                }
            });
        } catch (RuntimeException | Error failure) {
            loop.close();
            throw failure;
        }
    }

    private void tell(Consumer<RenderLoop.Listener> news) {
        SwingUtilities.invokeLater(() -> news.accept(presenter));
    }

    /**
     * Shows a scene and waits until its window is closed; without a size of the picture, the window has its own.
     *
     * @param inspection draws what is known of a patch and its period
     */
    public static void show(
            Scene scene,
            Environment environment,
            Consumer<String> warning,
            Dimension pictureSize,
            BiFunction<Patch, GratingPeriod, Drawing> inspection)
            throws InterruptedException {
        Viewer viewer = open(scene, environment, warning, pictureSize);
        SwingUtilities.invokeLater(() -> viewer.inspections.inspection = Optional.of(inspection));
        viewer.awaitEnd(PATIENCE_MILLISECONDS);
    }

    /** Shows a scene in a {@link Kiosk} and waits until it is closed. */
    public static void showKiosk(Scene scene, Environment environment, Consumer<String> warning)
            throws InterruptedException {
        openKiosk(scene, environment, warning).awaitEnd(PATIENCE_MILLISECONDS);
    }

    static Viewer openKiosk(Scene scene, Environment environment, Consumer<String> warning)
            throws InterruptedException {
        return open(scene, environment, warning, null, Kiosk::install);
    }

    /** Shows a scene, drags its light and its model for the given seconds each, closes the window and returns the measurements as text. */
    public static String measure(
            Scene scene, Environment environment, Consumer<String> warning, Dimension pictureSize, double seconds)
            throws InterruptedException {
        Viewer viewer = open(scene, environment, warning, pictureSize);
        try {
            new BackgroundTask<>(viewer.presenter.firstPicture).get();
            if (scene.method().isTable()) {
                viewer.presenter
                        .finalPicture
                        .exceptionally(none -> null)
                        .completeOnTimeout(null, LONGEST_WAIT_SECONDS, TimeUnit.SECONDS)
                        .join();
            }
            return viewer.journal.report() + System.lineSeparator() + ViewMeasurement.of(viewer, seconds);
        } finally {
            SwingUtilities.invokeLater(viewer::quit);
            viewer.awaitEnd(PATIENCE_MILLISECONDS);
        }
    }

    static Viewer open(Scene scene, Environment environment, Consumer<String> warning, Dimension pictureSize)
            throws InterruptedException {
        return open(scene, environment, warning, pictureSize, KeyControls::install);
    }

    private static Viewer open(
            Scene scene,
            Environment environment,
            Consumer<String> warning,
            Dimension pictureSize,
            Consumer<Viewer> controls)
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
                    Optional.ofNullable(viewer.get())
                            .ifPresent(shown -> SwingUtilities.invokeLater(() -> shown.window.status.message(line)));
                },
                // Drops remarks about patches: the panel shows them beside the patch's name.
                line -> {});
        // Loads the scene in the background while Swing starts, since Swing's start uses one processor only; first the
        // shape, which is shown before the rest is loaded.
        BackgroundTask<SceneShape> shape = BackgroundTask.start(() -> loader.shape(scene));
        BackgroundTask<LoadedScene> first = shape.then(() -> LoadedScene.load(loader, scene, shape));
        try {
            SwingUtilities.invokeAndWait(() -> {
                PlotFont.provide();
                // FlatLaf would draw its own frame on Windows, where that of the system is as good and also fits Wine.
                System.setProperty("flatlaf.useWindowDecorations", "false");
                FlatDarkLaf.setup();
                viewer.set(new Viewer(
                        scene,
                        (next, previous, progress) -> previous == null && next.equals(scene)
                                ? first.get()
                                : LoadedScene.load(loader, next, previous, progress),
                        GraphicsStage::new,
                        journal,
                        RecentFiles.of(environment)));
                controls.accept(viewer.get());
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

    /** Returns a failure to throw: with a message if the display does not answer or Java has no screen libraries. */
    private static RuntimeException unchecked(Throwable failure) {
        if (!(failure instanceof AWTError || failure instanceof LinkageError)) {
            return failure instanceof RuntimeException cause ? cause : new IllegalStateException(failure);
        }
        String why = String.valueOf(failure.getMessage()).strip().replaceAll("\\.$", "");
        return new GraphicsException("the viewer cannot open the screen: " + why
                + "; start it on a desktop, or set DISPLAY to an existing screen");
    }

    /** Shows the window, with a picture of the given size in screen pixels unless null, and the scene once its shape is loaded. */
    void start(Dimension pictureSize, Supplier<SceneShape> shape) {
        if (pictureSize != null) {
            window.fitPicture(pictureSize);
        }
        window.setVisible(true);
        journal.reached("window");
        window.picture.requestFocusInWindow();
        window.controls.follow();
        loop.showBody(model.scene(), shape, window.picture.pictureWidth(), window.picture.pictureHeight());
        model.load();
    }

    /**
     * Waits until the window is closed, running saves are done and the OpenGL context is closed; returns true if it is. A save that waits for a
     * final picture is dropped. Not on the event thread.
     *
     * @param patience longest wait for saves, and again for the context, milliseconds
     */
    boolean awaitEnd(long patience) throws InterruptedException {
        closed.await();
        writing.awaitEnd(patience);
        return loop.awaitEnd(patience);
    }

    void quit() {
        window.dispose();
    }

    private void end() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(dragListener);
        player.stop();
        loop.close();
        loading.close();
        writing.finish();
        inspector.stop();
        measuring.close();
        periods.close();
        inspections.close();
        presenter.noPicture("the window was closed");
        closed.countDown();
    }

    /** Makes all changes during which a mouse button is down (over the picture or on a slider) one undo step. */
    private void trackDrag(AWTEvent event) {
        if (event.getID() == MouseEvent.MOUSE_PRESSED || event.getID() == MouseEvent.MOUSE_RELEASED) {
            model.setDragging(event.getID() == MouseEvent.MOUSE_PRESSED);
        }
    }

    void reset() {
        open(sceneAsOpened, () -> {});
    }

    void open(Scene scene, Runnable opened) {
        model.open(scene, () -> {
            sceneAsOpened = scene;
            opened.run();
        });
    }

    /** Plays one {@link Motion} of the scene at a time until it is stopped. Used on the event thread only. */
    static final class Player {
        private static final int FRAME_MILLISECONDS = 16;
        private static final double RADIANS_PER_NANOSECOND = Math.toRadians(30) * 1e-9;

        private final ViewerModel model;
        private final Timer timer = new Timer(FRAME_MILLISECONDS, event -> advance());
        private final List<Runnable> listeners = new ArrayList<>();
        private Motion motion;
        private long last;

        Player(ViewerModel model) {
            this.model = model;
        }

        void onChange(Runnable listener) {
            listeners.add(listener);
        }

        boolean plays(Motion value) {
            return motion == value;
        }

        void toggle(Motion value) {
            play(plays(value) ? null : value);
        }

        void stop() {
            play(null);
        }

        private void play(Motion value) {
            motion = value;
            last = System.nanoTime();
            if (value == null) {
                timer.stop();
            } else {
                timer.start();
            }
            listeners.forEach(Runnable::run);
        }

        private void advance() {
            long now = System.nanoTime();
            double angle = (now - last) * RADIANS_PER_NANOSECOND;
            last = now;
            model.change(scene -> motion.at(scene, angle));
        }
    }
}
