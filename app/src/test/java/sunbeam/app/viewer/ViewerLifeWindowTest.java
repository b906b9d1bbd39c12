package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JTextField;
import jrtr.GraphicsException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.input.PngText;
import sunbeam.app.render.SceneLoader;
import sunbeam.app.render.SceneShape;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.viewer.loop.GraphicsStage;
import sunbeam.app.viewer.model.LoadedScene;
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
        Viewer blind = onEvents(() -> {
            Viewer made = new Viewer(
                    scene(),
                    (next, previous, progress) -> null,
                    () -> {
                        throw new GraphicsException("no OpenGL 3.3 here");
                    },
                    new StartJournal(),
                    RecentFiles.of(environment()));
            made.start(null, () -> null);
            return made;
        });
        assertThatThrownBy(blind::awaitPicture).hasMessageContaining("no OpenGL 3.3 here");
        onEvents(() -> {
            JLabel label = (JLabel) blind.window().picture().getComponent(0);
            assertThat(label.isVisible()).isTrue();
            assertThat(label.getText()).contains("no OpenGL 3.3 here");
            assertThat(Dialogs.all(blind.window().status(), JLabel.class))
                    .extracting(JLabel::getText)
                    .contains("No picture of this scene");
            blind.quit();
            return null;
        });
        blind.awaitEnd(PATIENCE_MILLISECONDS);
    }

    @Test
    void theBodyIsOnScreenBeforeThePatchIsLoaded() throws Exception {
        SceneLoader loader = new SceneLoader(environment(), line -> {});
        BackgroundTask<SceneShape> shape = BackgroundTask.start(() -> loader.shape(scene()));
        CompletableFuture<Void> patchMayLoad = new CompletableFuture<>();
        Viewer early = onEvents(() -> {
            Viewer made = new Viewer(
                    scene(),
                    (next, previous, progress) -> {
                        patchMayLoad.join();
                        return LoadedScene.load(loader, next, shape);
                    },
                    GraphicsStage::new,
                    new StartJournal(),
                    RecentFiles.of(environment()));
            made.start(new Dimension(80, 60), shape::get);
            return made;
        });
        PictureView view = early.window().picture();
        await(() -> onEvents(() -> view.picture().isPresent()));
        int[] body = onEvents(() -> view.picture().orElseThrow().getRGB(0, 0, 80, 60, null, 0, 80));
        // The white cylinder before the background, both of one color each but for the shading.
        assertThat(Arrays.stream(body).distinct().count()).isGreaterThan(8);
        assertThat(early.model().loaded()).isEmpty();
        patchMayLoad.complete(null);
        await(() -> onEvents(view::isFinal));
        onEvents(() -> {
            early.quit();
            return null;
        });
        early.awaitEnd(PATIENCE_MILLISECONDS);
    }

    @Test
    void aSavedPictureSaysHowItWasMade() throws Exception {
        Path picture = folder.resolve("picture.png");
        onEvents(() -> {
            viewer.files().savePicture(picture);
            return null;
        });
        await(() -> Files.exists(picture));
        assertThat(PngText.read(picture))
                .containsKeys("Scene", "Patch", "Method", "Size", "Exposure", "Parameters")
                .containsEntry(
                        "Plan",
                        onEvents(() -> viewer.model()
                                .loaded()
                                .orElseThrow()
                                .firstPart()
                                .method()
                                .summary()))
                .hasEntrySatisfying("Renderer", name -> assertThat(name).isNotBlank());
    }

    @Test
    void methodsAreChosenInThePanelAndOneThatCannotBeUsedIsRefused() throws Exception {
        BufferedImage full = picture();
        for (MethodChoice choice : new MethodChoice[] {choice("nmm"), choice("pq, linear"), choice("gem")}) {
            onEvents(() -> {
                control("method", JComboBox.class).setSelectedItem(choice);
                return null;
            });
            await(() -> onEvents(() -> MethodChoice.of(
                            viewer.model().loaded().orElseThrow().firstPart().scene())
                    == choice));
            awaitFinal();
        }
        assertThat(different(full, picture(), false)).as("gem is another model").isPositive();
        assertThat(onEvents(() -> viewer.model().scene().get(SceneSettings.DIFFRACTION)))
                .isEqualTo(0.5);
        onEvents(() -> {
            control("method", JComboBox.class).setSelectedItem(choice("full"));
            return null;
        });
        assertThat(onEvents(() -> viewer.model().scene().weights()))
                .as("as it was before gem")
                .isEqualTo(scene().weights());
        onEvents(() -> {
            control("method", JComboBox.class).setSelectedItem(choice("gem"));
            return null;
        });
        onEvents(() -> {
            JTextField spacing = control("spacing", JTextField.class);
            spacing.setText("2 parsec");
            spacing.postActionEvent();
            return null;
        });
        assertThat(onEvents(() -> viewer.window().status().text())).contains("Lines \"2 parsec\" has the unknown unit");
    }

    private static MethodChoice choice(String label) {
        return MethodChoice.ALL.stream()
                .filter(each -> each.toString().equals(label))
                .findFirst()
                .orElseThrow();
    }
}
