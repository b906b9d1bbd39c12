package sunbeam.app.viewer;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import jrtr.ContextInfo;
import jrtr.GraphicsException;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.optics.Direction;

/** The viewer: window, scene and render thread put together. Belongs to the event thread. */
final class Viewer {
    private static final long LOOK_MILLISECONDS = 100;

    private final ViewerModel model;
    private final ViewerWindow window;
    private final RenderLoop loop;
    private final FileActions files;
    private final PointInspector inspector;
    private final Background loading = new Background("loading");
    private final Background writing = new Background("files");
    private final CountDownLatch closed = new CountDownLatch(1);
    private final CompletableFuture<Void> firstPicture = new CompletableFuture<>();
    private final StartJournal journal;
    private final Sparing sparing;
    private Scene asLoaded;
    private FrameObserver observer = FrameObserver.NONE;
    private boolean coneShown = true;
    private boolean mapShown = true;
    private volatile boolean failed;
    private ViewState asked;
    private ViewState shown;
    private ViewState completed;
    // Of what is being loaded.
    private double loadedShare;

    /**
     * Puts everything together and opens OpenGL; nothing is shown yet.
     *
     * @param scene to begin with
     * @param loader loads scenes
     * @param sparing that the loader's last work waits for
     * @param opening opens OpenGL, on the render thread
     * @param journal of what is reached
     */
    Viewer(
            Scene scene,
            ViewerModel.Loading loader,
            Sparing sparing,
            Supplier<GraphicsStage> opening,
            StartJournal journal) {
        this.journal = journal;
        this.sparing = sparing;
        asLoaded = scene;
        model = new ViewerModel(scene, loader, loading);
        // OpenGL opens while the window is being made; what it has to say waits for the event thread.
        loop = new RenderLoop(opening, new FromRenderThread(), SwingUtilities::invokeLater);
        loop.start();
        try {
            window = new ViewerWindow(title(scene), model);
            inspector = new PointInspector(window);
            files = new FileActions(window, model, writing, this::open);
            KeyControls keys = new KeyControls(this, model, files);
            window.setJMenuBar(keys.menus());
            keys.install(window.picture());
            MouseControls.install(window.picture(), model, this::pick);
            model.setListener(new FromModel());
            window.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosed(WindowEvent event) {
                    end();
                }
            });
            window.picture().addComponentListener(new ComponentAdapter() {
                @Override
                public void componentResized(ComponentEvent event) {
                    show();
                }
            });
        } catch (RuntimeException | Error failure) {
            loop.close();
            throw failure;
        }
    }

    private static String title(Scene scene) {
        return scene.title().isBlank() ? "Sunbeam" : scene.title() + " - Sunbeam";
    }

    /** Shows the window and begins. */
    void start() {
        window.setVisible(true);
        journal.reached(StartJournal.Stage.WINDOW);
        window.picture().requestFocusInWindow();
        window.controls().follow();
        model.start();
    }

    ViewerWindow window() {
        return window;
    }

    ViewerModel model() {
        return model;
    }

    FileActions files() {
        return files;
    }

    PointInspector inspector() {
        return inspector;
    }

    /**
     * Waits until something is to be seen. Not on the event thread.
     *
     * @throws GraphicsException if it cannot be, says why
     */
    void awaitPicture() throws InterruptedException {
        try {
            firstPicture.get();
        } catch (ExecutionException failure) {
            throw new GraphicsException(failure.getCause().getMessage());
        }
    }

    /** Without effect once there has been a picture. */
    private void noPicture(String why) {
        firstPicture.completeExceptionally(new GraphicsException(why));
    }

    /** When what was reached. */
    StartJournal journal() {
        return journal;
    }

    /** Has somebody watch what comes on screen. */
    void observe(FrameObserver value) {
        observer = value;
    }

    /**
     * Waits until the window is closed, what is being saved is saved, and the graphics card given back; a picture that was
     * to be saved once it is final is not. Not on the event thread.
     *
     * @param patience for saving and for the graphics card, milliseconds each
     */
    void awaitEnd(long patience) throws InterruptedException {
        closed.await();
        writing.awaitEnd(patience);
        loop.awaitEnd(patience);
    }

    /** Whether nothing is left on the graphics card. */
    boolean hasEnded() throws InterruptedException {
        return loop.awaitEnd(1);
    }

    /** Whether the newest state that was asked for is on screen in its final form. */
    @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
    boolean isSettled() {
        return asked == completed;
    }

    /**
     * Waits until what moves is drawn by tables of colors, if it will be. Not on the event thread.
     *
     * @param patience milliseconds
     * @return whether it is
     */
    boolean awaitTables(long patience) throws InterruptedException {
        long end = System.nanoTime() + patience * 1_000_000;
        while (System.nanoTime() < end) {
            Optional<LoadedScene> loaded = model.loaded();
            if (loaded.isPresent() && loaded.get().isWhole() && !loaded.get().willMove()) {
                return false;
            }
            CompletableFuture<Boolean> moves = new CompletableFuture<>();
            loop.submit(stage -> moves.complete(stage.canMove()));
            try {
                if (moves.get(patience, TimeUnit.MILLISECONDS) && journal.has(StartJournal.Stage.COLORS)) {
                    return true;
                }
            } catch (ExecutionException | TimeoutException noAnswer) {
                return false;
            }
            Thread.sleep(LOOK_MILLISECONDS);
        }
        return false;
    }

    /**
     * Waits for the first final picture of a scene by tables of colors, which is all that its light needs of them; not for those
     * of other methods. Not on the event thread.
     *
     * @param patience milliseconds
     */
    void awaitFinalByTable(long patience) throws InterruptedException {
        long end = System.nanoTime() + patience * 1_000_000;
        boolean isByTable = model.loaded()
                .filter(loaded -> loaded.fine().levels().isPresent())
                .isPresent();
        while (isByTable && !failed && !journal.has(StartJournal.Stage.FINAL) && System.nanoTime() < end) {
            Thread.sleep(LOOK_MILLISECONDS);
        }
    }

    void quit() {
        window.dispose();
    }

    private void end() {
        loop.close();
        loading.close();
        writing.finish();
        inspector.close();
        noPicture("the window was closed");
        closed.countDown();
    }

    void showKeys() {
        KeyList.show(window);
    }

    void toggleCone() {
        coneShown = !coneShown;
        followLight();
    }

    void toggleMap() {
        mapShown = !mapShown;
        window.showMap(mapShown);
        show();
    }

    void reset() {
        open(asLoaded, () -> {});
    }

    private void open(Scene scene, Runnable opened) {
        model.open(scene, () -> {
            asLoaded = scene;
            window.setTitle(title(scene));
            opened.run();
        });
    }

    /** A line from the loader, such as a warning about a patch. */
    void message(String line) {
        SwingUtilities.invokeLater(() -> window.status().message(line));
    }

    /** Has the newest scene drawn in the picture's size. */
    private void show() {
        inspector.follow(model.scene());
        followLight();
        int width = window.picture().pictureWidth();
        int height = window.picture().pictureHeight();
        if (failed || width < 1 || height < 1 || model.loaded().isEmpty()) {
            return;
        }
        LoadedScene loaded = model.loaded().get();
        asked = new ViewState(
                loaded.parts(),
                loaded.coarse(),
                loaded.moving(),
                loaded.mapped(),
                width,
                height,
                mapLight().filter(light -> loaded.hasMap()));
        window.status().outdated();
        observer.asked(asked);
        loop.show(asked);
    }

    /** Dims what is not of the newest scene, and says what is being loaded, until that is on screen. */
    private void followLoad() {
        boolean old = isOld();
        window.picture().dim(old);
        if (old) {
            window.status().loading(wantedPart(), loadedShare);
        } else {
            window.status().loaded();
        }
    }

    private boolean isOld() {
        return shown == null || !shown.fine().suits(model.scene());
    }

    /** In a word, what the newest scene has that the picture on screen has not. */
    private String wantedPart() {
        Scene wanted = model.scene();
        Scene old = shown == null ? wanted : shown.fine().scene();
        if (!old.mesh().equals(wanted.mesh())) {
            return new File(wanted.mesh()).getName();
        }
        return shown == null || !old.patch().equals(wanted.patch())
                ? new File(wanted.patch().patch()).getName()
                : "method " + wanted.method().type().label();
    }

    private Optional<Direction> mapLight() {
        if (!mapShown) {
            return Optional.empty();
        }
        Optional<PickedPoint> picked = inspector.point();
        Optional<Direction> light = MapLight.of(model.scene(), picked);
        if (light.isEmpty()) {
            window.map().clear("the light is behind the skin here");
        } else {
            window.map().computed(0);
            window.map()
                    .mark(
                            picked.map(point -> point.pick().wr()),
                            picked.isPresent() ? "BRDF at the picked point" : "BRDF of a skin that faces you");
        }
        return light;
    }

    private void followLight() {
        window.picture()
                .showCone(coneShown ? Optional.of(new LightCone(MapLight.seen(model.scene()))) : Optional.empty());
        inspector.showAngles(model.scene().light().towards());
    }

    private void pick(int x, int y) {
        model.loaded()
                .ifPresent(loaded -> inspector.pick(loop, loaded.fine(), x, y, () -> {
                    show();
                    measure();
                }));
    }

    private void measure() {
        model.loaded().ifPresent(loaded -> inspector.measure(loaded.fine()));
    }

    /** The scene has changed. */
    private final class FromModel implements ViewerModel.Listener {
        @Override
        public void changed() {
            window.controls().follow();
            model.loaded().ifPresent(loaded -> {
                journal.reached(StartJournal.Stage.LOADED);
                window.status().plan(loaded.fine().method().summary());
            });
            show();
            followLoad();
        }

        @Override
        public void loading(double share) {
            if (!isOld()) {
                window.map().computed(share);
                return;
            }
            loadedShare = share;
            if (share == 0) {
                window.status().message(" "); // what was said of the last load
            }
            followLoad();
        }

        @Override
        public void problem(String message) {
            window.status().message(message);
            if (model.loaded().isEmpty()) {
                noPicture(message);
                window.picture().showMessage(message);
            }
        }
    }

    /** What the render thread has to say, on the event thread. */
    private final class FromRenderThread implements RenderListener {
        @Override
        public void opened(ContextInfo info) {
            journal.reached(StartJournal.Stage.CONTEXT);
            files.drawnBy(info.renderer());
            window.status().renderer(info.renderer());
        }

        @Override
        public void failed(String message) {
            failed = true;
            noPicture(message);
            window.picture().showMessage("No picture: " + message);
            window.status().message(message);
        }

        @Override
        public void refused(String message) {
            window.status().message(message);
            window.status().refused();
            noPicture(message);
            model.loadRest();
            if (window.picture().picture().isEmpty()) {
                window.picture().showMessage(message);
            }
        }

        @Override
        public void preview(
                ViewState state, BufferedImage image, int divisor, boolean tables, double exposure, long nanoseconds) {
            sparing.hold();
            show(state, image, false, tables || !state.isBare(), exposure);
            journal.reached(reached(state, tables));
            if (!state.isBare()) {
                model.loadRest();
            }
            window.status().preview(divisor, nanoseconds);
            // Swing paints before whatever is queued now.
            SwingUtilities.invokeLater(() -> observer.shown(state, divisor));
        }

        @Override
        public void waiting(double share) {
            window.status().waiting(share);
        }

        @Override
        @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
        public void complete(ViewState state, BufferedImage image, double exposure, long nanoseconds) {
            show(state, image, true, true, exposure);
            journal.reached(StartJournal.Stage.FINAL);
            completed = state;
            // Only now: it would take the processors from the picture, or from what moves in a moment.
            sparing.hold();
            model.loadRest();
            if (state == asked) {
                window.status().complete(nanoseconds);
            }
            files.pictureIsFinal(state.fine(), exposure);
            measure();
        }

        private static StartJournal.Stage reached(ViewState state, boolean tables) {
            if (!state.isBare()) {
                return StartJournal.Stage.FIRST;
            }
            return tables ? StartJournal.Stage.COLORS : StartJournal.Stage.BODY;
        }

        private void show(
                ViewState state, BufferedImage image, boolean isFinal, boolean hasDiffraction, double exposure) {
            firstPicture.complete(null);
            shown = state;
            followLoad();
            window.picture().showPicture(image, state.width(), state.height(), isFinal);
            if (hasDiffraction) {
                window.controls().exposureInUse(exposure);
            }
        }

        @Override
        public void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
            window.picture().showTile(image, x, y);
            window.status().refining(shareDone);
        }

        @Override
        @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
        public void map(ViewState state, BufferedImage image, boolean isFinal) {
            window.map().show(image);
            if (isFinal && state == asked) {
                window.map().computed(1);
            }
        }
    }
}
