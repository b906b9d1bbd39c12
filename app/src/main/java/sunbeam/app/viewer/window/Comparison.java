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
 * Has the other of two methods draw what the scene's own has drawn, in the same exposure: once that picture is final, and until something
 * newer is asked for. Belongs to the event thread.
 */
final class Comparison {
    private final ViewerWindow window;
    private final RenderLoop loop;
    private final ViewerModel.Loading loading;
    private final Background background;
    // What the scene's own method has drawn, and its exposure; null while that is out of date.
    private ViewState own;
    private double exposure;
    // What the other is to draw; null for nothing.
    private ViewState asked;
    private LoadedScene loaded;
    private Scene coming;

    /** @param background in which the other method's tables are made */
    Comparison(ViewerWindow window, RenderLoop loop, ViewerModel.Loading loading, Background background) {
        this.window = window;
        this.loop = loop;
        this.loading = loading;
        this.background = background;
    }

    /** Something newer is asked for: its own picture comes first. */
    void outdated() {
        own = null;
        asked = null;
        window.picture().divider().hide();
    }

    /** The newest state's own picture is final. */
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

    /** Whether the other method draws or has drawn. */
    boolean isAsked() {
        return asked != null;
    }

    /** Goes on without the other, which cannot be had. */
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
