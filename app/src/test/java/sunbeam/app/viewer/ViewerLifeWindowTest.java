package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import javax.swing.JLabel;
import javax.swing.JTextField;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.loop.GraphicsStage;
import sunbeam.app.viewer.model.LoadedScene;
import sunbeam.app.viewer.model.ViewerModel;
import sunbeam.app.viewer.panel.MethodChoice;
import sunbeam.app.viewer.picture.PictureView;
import sunbeam.app.viewer.window.RecentFiles;
import sunbeam.app.viewer.window.StartJournal;
import sunbeam.app.viewer.window.Viewer;
import sunbeam.app.work.BackgroundTask;

/** The viewer's panel and failures, in a real window. */
@Tag("window")
final class ViewerLifeWindowTest extends ViewerInAWindow {
    @Test
    void withoutOpenGLALabelSaysWhy() throws Exception {
        Viewer blind = start(
                (next, previous, progress) -> null,
                () -> {
                    throw new GraphicsException("no OpenGL 3.3 here");
                },
                () -> null);
        assertThatThrownBy(blind::awaitPicture).hasMessageContaining("no OpenGL 3.3 here");
        onEvents(() -> {
            JLabel label = (JLabel) blind.window().picture().getComponent(0);
            assertThat(label.isVisible()).isTrue();
            assertThat(label.getText()).contains("no OpenGL 3.3 here");
            assertThat(Dialogs.all(blind.window().status(), JLabel.class))
                    .extracting(JLabel::getText)
                    .contains("No picture of this scene");
            blind.quit();
        });
        blind.awaitEnd(PATIENCE_MILLISECONDS);
    }

    @Test
    void theBodyIsOnScreenBeforeThePatchIsLoaded() throws Exception {
        SceneLoader loader = new SceneLoader(environment(), line -> {});
        BackgroundTask<SceneShape> shape = BackgroundTask.start(() -> loader.shape(scene()));
        CompletableFuture<Void> patchMayLoad = new CompletableFuture<>();
        Viewer early = start(
                (next, previous, progress) -> {
                    patchMayLoad.join();
                    return LoadedScene.load(loader, next, shape);
                },
                GraphicsStage::new,
                shape::get);
        PictureView view = early.window().picture();
        awaitOnEvents(() -> view.picture().isPresent());
        int[] body = onEvents(() -> Pictures.pixels(view.picture().orElseThrow()));
        // The white cylinder before the background, both of one color each but for the shading.
        assertThat(Arrays.stream(body).distinct().count()).isGreaterThan(8);
        assertThat(early.model().loaded()).isEmpty();
        patchMayLoad.complete(null);
        awaitOnEvents(view::isFinal);
        onEvents(early::quit);
        early.awaitEnd(PATIENCE_MILLISECONDS);
    }

    private Viewer start(ViewerModel.Loading loading, Supplier<GraphicsStage> opening, Supplier<SceneShape> shape)
            throws Exception {
        return onEvents(() -> {
            Viewer made = new Viewer(scene(), loading, opening, new StartJournal(), RecentFiles.of(environment()));
            made.start(new Dimension(80, 60), shape);
            return made;
        });
    }

    @Test
    void methodsAreChosenInThePanelAndOneThatCannotBeUsedIsRefused() throws Exception {
        BufferedImage full = picture();
        for (String label : List.of("nmm", "pq, linear", "gem")) {
            choose("method", label);
            await(() -> MethodChoice.of(loaded().scene()).toString().equals(label));
            awaitFinal();
        }
        assertThat(different(full, picture(), false)).as("gem is another model").isPositive();
        assertThat(modelScene().get(SceneSettings.DIFFRACTION)).isEqualTo(0.5);
        choose("method", "full");
        assertThat(modelScene().weights()).as("as it was before gem").isEqualTo(scene().weights());
        choose("method", "gem");
        onEvents(() -> {
            JTextField spacing = control("spacing", JTextField.class);
            spacing.setText("2 parsec");
            spacing.postActionEvent();
        });
        assertThat(message()).contains("Lines \"2 parsec\" has the unknown unit");
    }
}
