package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import javax.swing.SwingUtilities;
import jrtr.GraphicsException;
import sunbeam.app.render.LightCone;
import sunbeam.app.render.SceneData;
import sunbeam.app.render.SceneSession;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.loop.Stage;
import sunbeam.app.viewer.loop.ViewState;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.precompute.analysis.Verdict;
import sunbeam.precompute.patch.Patch;

/** Presenter of the scene: requests pictures from the render thread and shows them. Used on the event thread only. */
public final class ScenePresenter implements ViewerModel.Listener, RenderLoop.Listener {

    private final Viewer viewer;
    private final ViewerModel model;
    private final ViewerWindow window;
    private final SplitViewPresenter splitView;
    private final MapPresenter map;
    // Both complete exceptionally if there will be no picture.
    final CompletableFuture<Void> firstPicture = new CompletableFuture<>();
    final CompletableFuture<Void> finalPicture = new CompletableFuture<>();
    private final Set<Overlay> overlays = EnumSet.of(Overlay.MAP);
    Optional<ViewMeasurement> measurement = Optional.empty();
    private boolean failed;
    String renderer = "";
    private ViewState requested;
    private ViewState shown;
    private RenderLoop.Finished completed;
    private double loadedShare;
    /** Sentence about the patch; a blank until it is known. */
    String verdict = " ";
    // Message about the last state that could not be drawn.
    private String refusal = "";

    ScenePresenter(Viewer viewer, ViewerModel.Loading loading) {
        this.viewer = viewer;
        model = viewer.model;
        window = viewer.window;
        splitView = new SplitViewPresenter(viewer, loading);
        map = new MapPresenter(viewer);
    }

    void noPicture(String why) {
        firstPicture.completeExceptionally(new GraphicsException(why));
        finalPicture.completeExceptionally(new GraphicsException(why));
    }

    /** Returns the final picture of the newest scene; empty until it is on screen. */
    Optional<RenderLoop.Finished> finished() {
        return Optional.ofNullable(completed)
                .filter(last -> SceneSharing.isSame(last.state(), requested)
                        && last.state().firstPart().suits(model.scene()));
    }

    boolean shows(Overlay overlay) {
        return overlays.contains(overlay);
    }

    void toggle(Overlay overlay) {
        if (!overlays.remove(overlay)) {
            overlays.add(overlay);
        }
        switch (overlay) {
            case CONE -> followLight();
            case STROKES -> {
                window.picture.showStrokes(Optional.empty());
                finished().ifPresent(whole -> requestStrokes());
            }
            case MAP -> {
                window.map.setVisible(shows(Overlay.MAP));
                show();
            }
        }
    }

    private void requestStrokes() {
        if (!shows(Overlay.STROKES)) {
            return;
        }
        ViewState drawn = requested;
        viewer.loop.submit(stage -> {
            BufferedImage strokes = stage.strokes(drawn.width(), drawn.height());
            SwingUtilities.invokeLater(() -> {
                if (SceneSharing.isSame(drawn, requested) && shows(Overlay.STROKES)) {
                    window.picture.showStrokes(Optional.of(strokes));
                }
            });
        });
    }

    static String title(Scene scene) {
        String own = scene.get(SceneSettings.TITLE);
        return own.isBlank() ? "Sunbeam" : own + " - Sunbeam";
    }

    void show() {
        viewer.inspector.follow(model.litScene());
        followLight();
        int width = window.picture.pictureWidth();
        int height = window.picture.pictureHeight();
        if (failed || width < 1 || height < 1 || model.loaded().isEmpty()) {
            return;
        }
        map.follow(shows(Overlay.MAP));
        ViewState next = new ViewState(model.loaded().get(), model.metering(), width, height, false);
        if (requested != null && next.showsThePictureOf(requested)) { // as after a pick or a refused load
            map.request(finished().isPresent());
            finished().ifPresent(whole -> followFinal());
            return;
        }
        requested = next;
        splitView.outdated();
        window.picture.showStrokes(Optional.empty());
        window.status.outdated();
        measurement.ifPresent(measured -> measured.requested(requested));
        viewer.loop.show(requested);
    }

    /** Draws the comparison method's picture anew if another method is chosen. */
    void compare() {
        splitView.outdated();
        finished().ifPresent(splitView::begin);
    }

    /** Dims the picture and shows what loads while the newest scene's mesh, patches or method are not on screen. */
    private void followLoad() {
        if (failed) {
            return;
        }
        boolean old = shown == null || !shown.firstPart().suits(model.scene());
        window.picture.dim(old && shown != null);
        if (old) {
            window.status.loading(
                    Optional.ofNullable(shown).map(state -> state.firstPart().scene()), model.scene(), loadedShare);
        } else {
            window.status.loaded();
        }
    }

    private void followLight() {
        LightCone cone = LightCone.of(model.drawnScene());
        window.picture.light.follow(cone);
        window.picture.showCone(shows(Overlay.CONE) ? Optional.of(cone) : Optional.empty());
        viewer.inspector.describe();
    }

    @Override
    public void changed() {
        window.controls.follow();
        window.setTitle(title(model.scene()));
        model.loaded().ifPresent(loaded -> viewer.journal.reached("patch, texture and plan"));
        show();
        followLoad();
    }

    @Override
    public void loading(double share) {
        loadedShare = share;
        if (share == 0) {
            window.status.message(" "); // clears the message of the last load
        }
        followLoad();
    }

    @Override
    public void problem(String message) {
        viewer.inspections.cancel();
        window.status.message(message);
        if (model.loaded().isEmpty()) {
            noPicture(message);
            window.picture.showMessage(message);
        }
    }

    @Override
    public void opened(String value) {
        viewer.journal.reached("OpenGL");
        renderer = value;
    }

    @Override
    public void failed(String message) {
        failed = true;
        noPicture(message);
        window.status.refused();
        window.picture.showMessage("No picture: " + message);
        window.status.message(message);
    }

    @Override
    public void refused(String message) {
        if (splitView.requested != null) {
            splitView.refused(message);
            return;
        }
        requested = null;
        refusal = message;
        window.status.message(message);
        window.status.refused();
        noPicture(message);
        if (shown == null) { // the body alone is no picture of the scene
            window.picture.showMessage(message);
        }
    }

    @Override
    public void body(BufferedImage image) {
        if (!firstPicture.isDone()) {
            window.picture.showPicture(image, image.getWidth(), image.getHeight());
            viewer.journal.reached("body");
        }
    }

    /** Such as "8 of 512 lights": previews have some of an environment's lights. */
    private String lights(ViewState state, OptionalInt drawn) {
        if (!state.firstPart().scene().hasEnvironment()) {
            return "";
        }
        OptionalInt all =
                completed == null ? OptionalInt.empty() : completed.picture().lights();
        return " · " + drawn.orElse(SceneSession.MOVING_LIGHTS) + (all.isPresent() ? " of " + all.getAsInt() : "")
                + " lights";
    }

    @Override
    public void preview(ViewState state, Stage.Preview preview) {
        if (state.isOther()) {
            splitView.preview(state, preview);
            return;
        }
        boolean isNew = !SceneSharing.isSame(state, shown);
        show(state, preview.image());
        if (preview.hasColors()) {
            window.controls.exposureInUse(preview.exposure());
        }
        viewer.journal.reached(preview.hasColors() ? "first picture" : "body");
        window.status.preview(preview.divisor(), isNew, lights(state, preview.lights()));
        map.request(false);
        // Runs after Swing has painted the picture.
        SwingUtilities.invokeLater(() -> measurement.ifPresent(measured -> measured.shown(state, preview.divisor())));
    }

    @Override
    public void waiting(double share) {
        window.status.progress(share, "Preview, %.0f %% of its colors made");
    }

    @Override
    public void complete(RenderLoop.Finished finished) {
        ViewState state = finished.state();
        Stage.Final picture = finished.picture();
        if (state.isOther()) {
            splitView.complete(finished);
            return;
        }
        show(state, picture.image());
        window.controls.exposureInUse(picture.exposure());
        viewer.journal.reached("final picture");
        completed = finished;
        finalPicture.complete(null);
        followFinal();
        if (SceneSharing.isSame(state, requested)) {
            map.request(true);
            window.status.complete(finished.nanoseconds(), picture.lights());
            requestStrokes();
            splitView.begin(finished);
        }
    }

    private void followFinal() {
        viewer.files.writeWaiting();
        viewer.inspector.measure();
        SceneData.ofRegions(completed.state().scene().parts(), SceneData::patch).forEach(viewer.periods::search);
        showPeriod();
    }

    /** Shows what the patch's period says, once it is known: the verdict, orders on the map, the picked points' sentences. */
    void showPeriod() {
        model.loaded().ifPresent(loaded -> {
            Patch patch = loaded.firstPart().patch();
            verdict = viewer.periods
                    .find(patch)
                    .map(period -> Verdict.of(patch, period, 0, 0).sentence() + ".")
                    .orElse(" ");
            window.status.caption(verdict);
        });
        viewer.inspections.showIfAwaited();
        map.markOrders();
        viewer.inspector.describe();
    }

    private void show(ViewState state, BufferedImage image) {
        firstPicture.complete(null);
        if (shown == null
                || !SceneSharing.isSame(
                        shown.firstPart().method(), state.firstPart().method())) {
            window.status.method(state.firstPart(), renderer);
        }
        shown = state;
        window.status.withdraw(refusal);
        followLoad();
        window.picture.showPicture(image, state.width(), state.height());
    }

    @Override
    public void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
        if (state.isOther()) {
            splitView.tile(state, image, x, y, shareDone);
            return;
        }
        window.picture.showTile(image, x, y);
        window.status.progress(shareDone, "Preview, %.0f %% final");
    }
}
