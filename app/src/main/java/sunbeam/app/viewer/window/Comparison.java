package sunbeam.app.viewer.window;

import java.awt.image.BufferedImage;
import java.util.OptionalDouble;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.loop.Stage;
import sunbeam.app.viewer.loop.ViewState;
import sunbeam.app.viewer.model.Background;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.panel.ControlOrigin;
import sunbeam.app.viewer.panel.MethodChoice;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.text.Text;

/**
 * Presenter of the split view: requests the comparison method's picture, in the same exposure, when the scene's own picture is final, until
 * a newer state comes. Used on the event thread only.
 */
final class Comparison {
    private final ViewerWindow window;
    private final RenderLoop loop;
    private final ViewerModel.Loading loading;
    private final Background background;
    // State of the final picture by the scene's own method, with its exposure; null if outdated.
    private ViewState own;
    private double exposure;
    // State requested from the comparison method; null for none.
    private ViewState asked;
    private LoadedScene loaded;
    private Scene coming;

    /** @param background worker that makes the comparison method's tables */
    Comparison(ViewerWindow window, RenderLoop loop, ViewerModel.Loading loading, Background background) {
        this.window = window;
        this.loop = loop;
        this.loading = loading;
        this.background = background;
    }

    /** Forgets the final picture because a newer state comes first. */
    void outdated() {
        own = null;
        asked = null;
        window.picture().divider().hide();
    }

    /** Requests the comparison's picture; called when the newest state's own picture is final. */
    void begin(ViewState state, double exposureInUse) {
        own = state;
        exposure = exposureInUse;
        follow();
    }

    private void follow() {
        if (own == null) {
            return;
        }
        Scene scene = own.fine().scene();
        window.controls()
                .compared(scene)
                .map(other -> other.with(
                        Choices.at(ControlOrigin.INSTANCE).with(SceneSettings.EXPOSURE, OptionalDouble.of(exposure))))
                .ifPresent(this::draw);
    }

    @SuppressWarnings("ReferenceEquality") // the same object as long as nothing is loaded anew
    private void draw(Scene scene) {
        if (loaded != null
                && loaded.fine().mesh() == own.fine().mesh()
                && loaded.fine().suits(scene)) {
            loaded = loaded.with(scene);
            asked = own.by(loaded);
            window.picture().divider().show(null, ownWords(), words(), false);
            loop.show(asked);
            return;
        }
        window.picture().divider().show(null, ownWords(), MethodChoice.of(scene) + " is being prepared", false);
        if (coming != null && coming.sharesParts(scene)) {
            return;
        }
        coming = scene;
        LoadedScene previous = own.scene();
        background.run(
                () -> loading.load(scene, previous, share -> {}),
                result -> {
                    coming = null;
                    loaded = result;
                    follow();
                },
                problem -> {
                    coming = null;
                    refused(problem);
                });
    }

    private String ownWords() {
        return MethodChoice.of(own.fine().scene()).toString();
    }

    private String words() {
        return MethodChoice.of(asked.fine().scene()).toString();
    }

    /** True if the comparison method's picture is requested or shown. */
    boolean isAsked() {
        return asked != null;
    }

    /** Ends the comparison because its method failed. */
    void refused(String problem) {
        asked = null;
        window.picture().divider().hide();
        window.status().message(problem);
    }

    @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
    void preview(ViewState state, Stage.Preview preview) {
        if (state == asked) {
            window.picture().divider().show(preview.image(), ownWords(), words() + ", preview", false);
        }
    }

    @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
    void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
        if (state == asked) {
            String done = Text.format(", %.0f %% final", Math.floor(100 * shareDone));
            window.picture().divider().showTile(image, x, y, words() + done);
        }
    }

    @SuppressWarnings("ReferenceEquality") // the same request, not an equal one
    void complete(ViewState state, Stage.Final picture) {
        if (state == asked) {
            window.picture().divider().show(picture.image(), ownWords(), words(), true);
        }
    }
}
