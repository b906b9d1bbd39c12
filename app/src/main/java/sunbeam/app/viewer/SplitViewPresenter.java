package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.OptionalDouble;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.viewer.ControlPanel.ControlOrigin;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.loop.Stage;
import sunbeam.app.viewer.loop.ViewState;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.precompute.color.Primaries;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;

/**
 * Presenter of the split view. When the scene's own picture is final, it requests the comparison method's picture with the same exposure; a
 * newer state ends that request. Used on the event thread only.
 */
final class SplitViewPresenter {
    private final Viewer viewer;
    private final ViewerWindow window;
    private final Divider divider;
    private final ViewerModel.Loading loading;
    // Final picture by the scene's own method; null if outdated.
    private RenderLoop.Finished own;
    ViewState requested;
    private long previewed;
    private LoadedScene loaded;
    private Scene preparing;

    SplitViewPresenter(Viewer viewer, ViewerModel.Loading loading) {
        this.viewer = viewer;
        this.loading = loading;
        window = viewer.window;
        divider = window.picture.divider;
    }

    void outdated() {
        own = null;
        requested = null;
        divider.hide();
    }

    void begin(RenderLoop.Finished finished) {
        own = finished;
        requestPicture();
    }

    private void requestPicture() {
        if (own == null) {
            return;
        }
        OptionalDouble exposure = OptionalDouble.of(own.picture().exposure());
        Choices sameExposure = Choices.at(ControlOrigin.INSTANCE).with(SceneSettings.EXPOSURE, exposure);
        window.controls
                .compared(own.state().firstPart().scene())
                .ifPresent(scene -> draw(
                        own.state(),
                        scene.with(SceneSettings.KEEPS_SURROUNDINGS, true).with(sameExposure)));
    }

    private void draw(ViewState shown, Scene scene) {
        if (loaded != null
                && SceneSharing.isSame(
                        loaded.firstPart().shape().whole(),
                        shown.firstPart().shape().whole())
                && loaded.firstPart().suits(scene)) {
            loaded = loaded.with(scene);
            requested = new ViewState(loaded, shown.metering(), shown.width(), shown.height(), true);
            divider.show(null, words(shown), words(requested) + ", being drawn", false);
            viewer.loop.show(requested);
            return;
        }
        divider.show(null, words(shown), MethodChoice.of(scene) + " is being prepared", false);
        if (preparing != null && SceneSharing.sharesParts(preparing, scene)) {
            return;
        }
        preparing = scene;
        viewer.loading.run(
                () -> loading.load(scene, shown.scene(), share -> {}),
                result -> {
                    preparing = null;
                    loaded = result;
                    requestPicture();
                },
                problem -> {
                    preparing = null;
                    refused(problem);
                });
    }

    private static String words(ViewState state) {
        Scene scene = state.firstPart().scene();
        boolean isSrgb = scene.display(1).primaries() == Primaries.SRGB;
        return MethodChoice.of(scene) + (isSrgb ? "" : " (primaries: CIE RGB)");
    }

    void refused(String problem) {
        requested = null;
        divider.hide();
        window.status.message(problem);
    }

    void preview(ViewState state, Stage.Preview preview) {
        if (SceneSharing.isSame(state, requested)) {
            previewed = System.nanoTime();
            String words = Text.format(
                    "%s, preview%s, final in about %.0f s",
                    words(requested), StatusLine.scale(preview.divisor()), Math.ceil(preview.secondsToFinal()));
            divider.show(preview.image(), words(own.state()), words, false);
        }
    }

    void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
        if (SceneSharing.isSame(state, requested)) {
            String done = Text.format(", %.0f %% final", Math.floor(100 * shareDone))
                    + StatusLine.remaining(previewed, shareDone);
            divider.showTile(image, x, y, words(requested) + done);
        }
    }

    void complete(RenderLoop.Finished finished) {
        if (SceneSharing.isSame(finished.state(), requested)) {
            divider.show(finished.picture().image(), words(own.state()), words(requested), true);
        }
    }
}
