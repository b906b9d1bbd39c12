package sunbeam.app.viewer.window;

import java.awt.AWTEvent;
import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import jrtr.GraphicsException;
import sunbeam.app.render.SceneLoader.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.viewer.loop.GraphicsStage;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.model.Background;
import sunbeam.app.viewer.model.Drags;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.app.viewer.window.ViewMeasurement.StartJournal;
import sunbeam.precompute.method.TableMethod;

/** Viewer: creates and connects window, model and render thread. Used on the event thread only. */
public final class Viewer {

    private final ViewerModel model;
    private final ViewerWindow window;
    final RenderLoop loop;
    private final FileActions files;
    private final PointInspector inspector;
    final Background loading = new Background("loading");
    final Background writing = new Background("files");
    final Background measuring = new Background("spectrum");
    private final CountDownLatch closed = new CountDownLatch(1);
    private final StartJournal journal;
    private final ScenePresenter presenter;
    private final Player player;
    private final AWTEventListener dragListener = this::trackDrag;
    private Scene sceneAsOpened;

    public Viewer(
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
        loop = new RenderLoop(opening, this::tell);
        loop.start();
        try {
            window = new ViewerWindow(ScenePresenter.title(scene), model);
            inspector = new PointInspector(this);
            files = new FileActions(this, recent);
            presenter = new ScenePresenter(this, loader);
            window.controls().onComparison(presenter::show);
            Toolkit.getDefaultToolkit().addAWTEventListener(dragListener, AWTEvent.MOUSE_EVENT_MASK);
            model.setListener(presenter);
            window.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosed(WindowEvent event) {
                    end();
                }
            });
            window.picture().addComponentListener(new ComponentAdapter() {
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

    /** Shows the window, with a picture of the given size in screen pixels unless null, and the scene once its shape is loaded. */
    public void start(Dimension pictureSize, Supplier<SceneShape> shape) {
        if (pictureSize != null) {
            window.fitPicture(pictureSize);
        }
        window.setVisible(true);
        journal.reached("window");
        window.picture().requestFocusInWindow();
        window.controls().follow();
        PictureView picture = window.picture();
        loop.showBody(model.scene(), shape, picture.pictureWidth(), picture.pictureHeight());
        model.load();
    }

    public ViewerWindow window() {
        return window;
    }

    public ViewerModel model() {
        return model;
    }

    public ScenePresenter presenter() {
        return presenter;
    }

    public Player player() {
        return player;
    }

    public FileActions files() {
        return files;
    }

    public PointInspector inspector() {
        return inspector;
    }

    /** Throws {@link GraphicsException} if there will be no picture. Must not be called on the event thread. */
    public void awaitPicture() throws InterruptedException {
        try {
            presenter.firstPicture().get();
        } catch (ExecutionException failure) {
            throw new GraphicsException(failure.getCause().getMessage());
        }
    }

    public StartJournal journal() {
        return journal;
    }

    /**
     * Waits until the window is closed, running saves are done and the OpenGL context is closed; returns true if it is. A save that waits for a
     * final picture is dropped. Not on the event thread.
     *
     * @param patience longest wait for saves, and again for the context, milliseconds
     */
    public boolean awaitEnd(long patience) throws InterruptedException {
        closed.await();
        writing.awaitEnd(patience);
        return loop.awaitEnd(patience);
    }

    /**
     * Waits for the first final picture of a scene with color tables; returns at once for other methods. Not on the event thread.
     *
     * @param patience longest wait, milliseconds
     */
    public void awaitFinalByTable(long patience) throws InterruptedException {
        if (model.scene().method().type().equals(TableMethod.TYPE)) {
            try {
                presenter.finalPicture().get(patience, TimeUnit.MILLISECONDS);
            } catch (ExecutionException | TimeoutException none) {
                return;
            }
        }
    }

    public void quit() {
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
        presenter.noPicture("the window was closed");
        closed.countDown();
    }

    /** Makes all changes during which a mouse button is down (over the picture or on a slider) one undo step. */
    private void trackDrag(AWTEvent event) {
        if (event.getID() == MouseEvent.MOUSE_PRESSED || event.getID() == MouseEvent.MOUSE_RELEASED) {
            model.setDragging(event.getID() == MouseEvent.MOUSE_PRESSED);
        }
    }

    public void zoom(double factor) {
        model.change(scene -> Drags.zoomed(scene, factor, 0, 0, 1, 1));
    }

    public Scene sceneAsOpened() {
        return sceneAsOpened;
    }

    public void reset() {
        open(sceneAsOpened, () -> {});
    }

    public void open(Scene scene, Runnable opened) {
        model.open(scene, () -> {
            sceneAsOpened = scene;
            opened.run();
        });
    }

    /** Callable on any thread. */
    public void message(String line) {
        SwingUtilities.invokeLater(() -> window.status().message(line));
    }
}
