package sunbeam.app.viewer;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import jrtr.ContextInfo;
import org.joml.Vector3f;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Geometry;

/** The viewer: window, scene and render thread put together. Belongs to the event thread. */
final class Viewer {
    // Light at the horizon leaves no radiance to divide by.
    private static final double LOWEST_LIGHT = 0.01;

    private final ViewerModel model;
    private final ViewerWindow window;
    private final RenderLoop loop;
    private final FileActions files;
    private final Background loading = new Background("loading");
    private final Background writing = new Background("files");
    private final Background measuring = new Background("spectrum");
    private final CountDownLatch closed = new CountDownLatch(1);
    private final AtomicLong newestSpectrum = new AtomicLong();
    private Scene asLoaded;
    private Optional<PickedPoint> picked = Optional.empty();
    private boolean coneShown = true;
    private boolean mapShown = true;
    private boolean failed;
    private ViewState asked;
    private ViewState completed;

    /**
     * Puts everything together; nothing is shown yet.
     *
     * @param scene to begin with
     * @param loader loads a scene, given the last one (null at first)
     * @param opening opens OpenGL, on the render thread
     */
    Viewer(Scene scene, BiFunction<Scene, LoadedScene, LoadedScene> loader, Supplier<GraphicsStage> opening) {
        asLoaded = scene;
        model = new ViewerModel(scene, loader, loading);
        window = new ViewerWindow(title(scene), model);
        loop = new RenderLoop(opening, new FromRenderThread());
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
    }

    private static String title(Scene scene) {
        return scene.title().isBlank() ? "Sunbeam" : scene.title() + " - Sunbeam";
    }

    /** Shows the window and begins. */
    void start() {
        window.setVisible(true);
        window.picture().requestFocusInWindow();
        window.controls().follow();
        loop.start();
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

    /** Waits until the window is closed and the graphics card given back. Not on the event thread. */
    void awaitEnd(long millisecondsForGraphics) throws InterruptedException {
        closed.await();
        loop.awaitEnd(millisecondsForGraphics);
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

    void quit() {
        window.dispose();
    }

    private void end() {
        newestSpectrum.incrementAndGet();
        loop.close();
        loading.close();
        writing.close();
        measuring.close();
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
        open(asLoaded);
    }

    private void open(Scene scene) {
        asLoaded = scene;
        window.setTitle(title(scene));
        model.change(old -> scene);
    }

    /** A line from the loader, such as a warning about a patch. */
    void message(String line) {
        SwingUtilities.invokeLater(() -> window.status().message(line));
    }

    /** Has the newest scene drawn in the picture's size. */
    private void show() {
        int width = window.picture().pictureWidth();
        int height = window.picture().pictureHeight();
        if (failed || width < 1 || height < 1 || model.loaded().isEmpty()) {
            return;
        }
        LoadedScene loaded = model.loaded().get();
        asked = new ViewState(loaded.fine(), loaded.coarse(), width, height, mapLight());
        loop.show(asked);
    }

    /** At the picked point, or on a surface that faces the viewer. */
    private Optional<Direction> mapLight() {
        if (!mapShown) {
            return Optional.empty();
        }
        Direction light = picked.map(point -> point.light(model.scene().light().towards()))
                .orElseGet(() -> {
                    Vector3f seen = lightSeen();
                    return new Direction(seen.x, seen.y, seen.z);
                });
        if (light.z() < LOWEST_LIGHT) {
            window.map().clear("the light is behind the skin here");
            return Optional.empty();
        }
        window.map()
                .mark(
                        picked.map(point -> point.pick().wr()),
                        picked.isPresent() ? "BRDF at the picked point" : "BRDF of a skin that faces you");
        return Optional.of(light);
    }

    private Vector3f lightSeen() {
        return model.scene()
                .view()
                .camera()
                .worldToCamera()
                .transformDirection(model.scene().light().towards(), new Vector3f());
    }

    private void followLight() {
        window.picture().showCone(coneShown ? Optional.of(new LightCone(lightSeen())) : Optional.empty());
        picked.ifPresent(
                point -> window.pick().show(point.describe(model.scene().light().towards())));
    }

    private void pick(int x, int y) {
        int width = window.picture().pictureWidth();
        int height = window.picture().pictureHeight();
        if (x < 0 || y < 0 || x >= width || y >= height || model.loaded().isEmpty()) {
            return;
        }
        // What is being drawn, not what a load may bring.
        Scene scene = model.loaded().get().fine().scene();
        loop.submit(stage -> {
            Optional<Pick> pick = stage.pick(x, y, width, height);
            SwingUtilities.invokeLater(() -> picked(pick.map(found -> new PickedPoint(scene, found, x, y))));
        });
    }

    private void picked(Optional<PickedPoint> point) {
        picked = point.filter(found -> found.staysIn(model.scene()));
        if (picked.isEmpty()) {
            window.pick().clear();
        }
        followLight();
        measure();
        show();
    }

    /** Colour and spectrum of the picked point, from the picture that has just become final. */
    private void measure() {
        long number = newestSpectrum.incrementAndGet();
        if (picked.isEmpty() || model.loaded().isEmpty()) {
            return;
        }
        PickedPoint point = picked.get();
        window.picture().picture().ifPresent(image -> {
            if (point.x() < image.getWidth() && point.y() < image.getHeight()) {
                window.pick().showColor(image.getRGB(point.x(), point.y()));
            }
        });
        SceneData data = model.loaded().get().fine();
        Direction wi = point.light(data.scene().light().towards());
        if (wi.z() <= 0 || point.pick().wr().z() <= 0) {
            window.pick().showSpectrum(new double[0]);
            return;
        }
        Geometry geometry = new Geometry(wi, point.pick().wr());
        measuring.run(
                () -> Spectrum.of(data, geometry, () -> number != newestSpectrum.get()),
                powers -> {
                    if (number == newestSpectrum.get()) {
                        window.pick().showSpectrum(powers);
                    }
                },
                window.status()::message);
    }

    /** The scene has changed. */
    private final class FromModel implements ViewerModel.Listener {
        @Override
        public void changed() {
            if (picked.isPresent() && !picked.get().staysIn(model.scene())) {
                picked = Optional.empty();
                window.pick().clear();
            }
            window.controls().follow();
            followLight();
            model.loaded()
                    .ifPresent(loaded ->
                            window.status().plan(loaded.fine().method().summary()));
            show();
        }

        @Override
        public void loading(boolean active) {
            window.status().busy(active);
        }

        @Override
        public void problem(String message) {
            window.status().message(message);
            if (model.loaded().isEmpty()) {
                window.picture().showMessage(message);
            }
        }
    }

    /** What the render thread has to say, taken to the event thread. */
    private final class FromRenderThread implements RenderListener {
        @Override
        public void opened(ContextInfo info) {
            SwingUtilities.invokeLater(() -> window.status().renderer(info.renderer()));
        }

        @Override
        public void failed(String message) {
            SwingUtilities.invokeLater(() -> {
                failed = true;
                window.picture().showMessage("No picture: " + message);
                window.status().message(message);
            });
        }

        @Override
        public void refused(String message) {
            SwingUtilities.invokeLater(() -> window.status().message(message));
        }

        @Override
        public void picture(ViewState state, BufferedImage image, boolean isFinal, double exposure, long nanoseconds) {
            SwingUtilities.invokeLater(() -> {
                window.picture().showPicture(image, state.width(), state.height(), isFinal);
                window.controls().exposureInUse(exposure);
                if (isFinal) {
                    completed = state;
                    window.status().complete(nanoseconds);
                    files.pictureIsFinal();
                    measure();
                } else {
                    window.status().preview((int) Math.ceil((double) state.width() / image.getWidth()), nanoseconds);
                }
            });
        }

        @Override
        public void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
            SwingUtilities.invokeLater(() -> {
                window.picture().showTile(image, x, y);
                window.status().refining(shareDone);
            });
        }

        @Override
        public void map(ViewState state, BufferedImage image, boolean isFinal) {
            SwingUtilities.invokeLater(() -> window.map().show(image));
        }
    }
}
