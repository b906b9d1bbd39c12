package sunbeam.app.viewer.window;

import java.awt.image.BufferedImage;
import java.io.File;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javax.swing.SwingUtilities;
import jrtr.ContextInfo;
import jrtr.GraphicsException;
import sunbeam.app.render.LightCone;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.loop.Stage;
import sunbeam.app.viewer.loop.ViewState;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.panel.MethodChoice;
import sunbeam.app.viewer.pick.PointInspector;
import sunbeam.precompute.plan.MethodSettings;

/** Presenter of the scene: requests pictures from the render thread and shows them. Used on the event thread only. */
public final class ScenePresenter implements ViewerModel.Listener, RenderLoop.Listener {
    private final ViewerModel model;
    private final ViewerWindow window;
    private final RenderLoop loop;
    private final FileActions files;
    private final PointInspector inspector;
    private final StartJournal journal;
    private final SplitViewPresenter splitView;
    private final MapPresenter map;
    private final CompletableFuture<Void> firstPicture = new CompletableFuture<>();
    private Optional<ViewMeasurement> measurement = Optional.empty();
    private final StrokesPresenter strokes;
    private boolean coneShown;
    private volatile boolean failed;
    private ViewState requested;
    private ViewState shown;
    private ViewState completed;
    private double loadedShare;

    ScenePresenter(
            ViewerModel model,
            ViewerWindow window,
            RenderLoop loop,
            FileActions files,
            PointInspector inspector,
            StartJournal journal,
            SplitViewPresenter splitView,
            MapPresenter map) {
        this.model = model;
        this.window = window;
        this.loop = loop;
        this.files = files;
        this.inspector = inspector;
        this.journal = journal;
        this.splitView = splitView;
        this.map = map;
        this.strokes = new StrokesPresenter(window.picture(), loop);
    }

    /** Returns a future that completes with the first picture, or exceptionally if there will be none. */
    CompletableFuture<Void> firstPicture() {
        return firstPicture;
    }

    void noPicture(String why) {
        firstPicture.completeExceptionally(new GraphicsException(why));
    }

    void observe(Optional<ViewMeasurement> value) {
        measurement = value;
    }

    /** True if the newest requested state's final picture is on screen. */
    @SuppressWarnings("ReferenceEquality") // compares requests by identity
    public boolean isSettled() {
        return requested == completed;
    }

    /** True if drawing has ended for good. Callable on any thread. */
    boolean hasFailed() {
        return failed;
    }

    public void toggleCone() {
        coneShown = !coneShown;
        followLight();
    }

    public boolean isConeShown() {
        return coneShown;
    }

    public void toggleStrokes() {
        strokes.toggle(isSettled());
    }

    public boolean areStrokesShown() {
        return strokes.areShown();
    }

    public void toggleMap() {
        map.toggle();
        show();
    }

    public boolean isMapShown() {
        return map.isShown();
    }

    static String title(Scene scene) {
        String own = scene.get(SceneSettings.TITLE);
        return own.isBlank() ? "Sunbeam" : own + " - Sunbeam";
    }

    void show() {
        inspector.follow(model.scene());
        followLight();
        int width = window.picture().pictureWidth();
        int height = window.picture().pictureHeight();
        if (failed || width < 1 || height < 1 || model.loaded().isEmpty()) {
            return;
        }
        LoadedScene loaded = model.loaded().get();
        requested = new ViewState(loaded, width, height, map.follow(), map.region(), false);
        splitView.outdated();
        window.picture().outdated();
        strokes.outdated();
        window.status().outdated();
        measurement.ifPresent(measured -> measured.requested(requested));
        loop.show(requested);
    }

    /** Dims the picture and shows the name of the loading part while the newest scene's mesh, patches or method are not on screen. */
    private void followLoad() {
        if (failed) {
            return;
        }
        boolean old = shown == null || !shown.firstPart().suits(model.scene());
        window.picture().dim(old && shown != null);
        if (old) {
            window.status().loading(wantedPart(), loadedShare);
        } else {
            window.status().loaded();
        }
    }

    /** Returns the name of the loading part: the mesh, patch or method in which the newest scene differs from the one on screen. */
    private String wantedPart() {
        Scene wanted = model.scene();
        Scene old = shown == null ? wanted : shown.firstPart().scene();
        if (!old.mesh().equals(wanted.mesh())) {
            return new File(wanted.mesh().name()).getName();
        }
        return shown == null || !old.patches().equals(wanted.patches())
                ? new File(wanted.patch().patch()).getName()
                : "method " + wanted.method().type().label();
    }

    private void followLight() {
        window.picture().showCone(coneShown ? Optional.of(LightCone.of(model.scene())) : Optional.empty());
        inspector.showAngles(model.scene().light().towards());
    }

    @Override
    public void changed() {
        window.controls().follow();
        window.setTitle(title(model.scene()));
        model.loaded().ifPresent(loaded -> journal.reached(StartJournal.Stage.LOADED));
        show();
        followLoad();
    }

    @Override
    public void loading(double share) {
        loadedShare = share;
        if (share == 0) {
            window.status().message(" "); // clears the message of the last load
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
        window.status().refused();
        window.picture().showMessage("No picture: " + message);
        window.status().message(message);
    }

    @Override
    public void refused(String message) {
        if (splitView.isRequested()) {
            splitView.refused(message);
            return;
        }
        window.status().message(message);
        window.status().refused();
        noPicture(message);
        if (shown == null) { // the body alone is no picture of the scene
            window.picture().showMessage(message);
        }
    }

    @Override
    public void body(BufferedImage image) {
        if (!firstPicture.isDone()) {
            window.picture().showPicture(image, image.getWidth(), image.getHeight(), false);
            journal.reached(StartJournal.Stage.BODY);
        }
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // compares requests by identity
    public void preview(ViewState state, Stage.Preview preview) {
        if (state.isOther()) {
            splitView.preview(state, preview);
            return;
        }
        boolean isNew = state != shown;
        double divisor = preview.divisor();
        boolean hasColors = preview.hasColors();
        show(state, preview.image(), false, hasColors, preview.exposure());
        journal.reached(hasColors ? StartJournal.Stage.FIRST : StartJournal.Stage.BODY);
        if (isNew) {
            window.status().moving(divisor);
        } else {
            window.status().still(divisor);
        }
        // Runs after Swing has painted the picture.
        SwingUtilities.invokeLater(() -> measurement.ifPresent(measured -> measured.shown(state, divisor)));
    }

    @Override
    public void waiting(double share) {
        window.status().waiting(share);
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // compares requests by identity
    public void complete(ViewState state, Stage.Final picture, long nanoseconds) {
        if (state.isOther()) {
            splitView.complete(state, picture);
            return;
        }
        show(state, picture.image(), state == requested, true, picture.exposure());
        journal.reached(StartJournal.Stage.FINAL);
        completed = state;
        if (state == requested) {
            window.status().complete(nanoseconds);
            strokes.request();
        }
        files.pictureIsFinal(state.scene(), picture.exposure());
        inspector.measure();
        if (state == requested) {
            splitView.begin(state, picture.exposure());
        }
    }

    private void show(ViewState state, BufferedImage image, boolean isFinal, boolean hasColors, double exposure) {
        firstPicture.complete(null);
        showMethod(state.firstPart());
        shown = state;
        followLoad();
        window.picture().showPicture(image, state.width(), state.height(), isFinal);
        if (hasColors) {
            window.controls().exposureInUse(exposure);
        }
    }

    @SuppressWarnings("ReferenceEquality") // unchanged parts keep their objects
    private void showMethod(SceneData data) {
        if (shown == null || shown.firstPart().method() != data.method()) {
            MethodChoice choice = MethodChoice.of(data.scene());
            String tolerance = choice.hasTolerance()
                    ? ", tolerance " + data.scene().choices().written(MethodSettings.TOLERANCE)
                    : "";
            List<String> details = new ArrayList<>(List.of(data.method().summary()));
            details.addAll(data.method().reasons());
            window.status().method(choice + tolerance, details);
        }
    }

    @Override
    public void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
        if (state.isOther()) {
            splitView.tile(state, image, x, y, shareDone);
            return;
        }
        window.picture().showTile(image, x, y);
        window.status().refining(shareDone);
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // compares requests by identity
    public void map(ViewState state, BufferedImage image, boolean isFinal) {
        map.show(image, state.mapLight(), isFinal && state == requested);
    }
}
