package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.files.input.PngText;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.setting.Choices;

/** Saves and loads scenes and pictures through the window's keys and dialogs. */
@Tag("window")
final class ViewerFilesWindowTest extends ViewerInAWindow {
    @Test
    void aSceneThatIsSavedAndLoadedAgainShowsTheSamePicture() throws Exception {
        Path patch = PatchFiles.descriptor(folder, "waves");
        onEvents(() -> {
            viewer.files().loadPatch(patch);
            viewer.model()
                    .change(scene -> scene.with(Choices.none().with(SceneSettings.ROTATE_PATCH, 0.3))
                            .with(SceneSettings.TEXTURE, "elaphe"));
        });
        await(() -> loaded().suits(modelScene()));
        drag(InputEvent.BUTTON1_DOWN_MASK);
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        BufferedImage saved = picture();
        Scene scene = modelScene();
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        Dialogs.choose("Save scene", folder.resolve("mine"));
        await(() -> message().contains("mine.json"));
        press(KeyEvent.VK_HOME);
        await(() -> loaded().scene().equals(scene()));

        press(KeyEvent.VK_CONTROL, KeyEvent.VK_O);
        Dialogs.choose("Load scene", folder.resolve("mine.json"));
        await(() -> loaded().scene().patch().equals(scene.patch()));
        awaitFinal();
        assertThat(picture()).isNotSameAs(saved);
        assertThat(different(saved, picture(), false)).isZero();
        assertThat(message()).contains("loaded mine.json");
        assertThat(onEvents(() -> viewer.files().recent())).containsExactly(folder.resolve("mine.json"));
        Scene again = modelScene();
        press(KeyEvent.VK_RIGHT);
        await(() -> !loaded().scene().equals(again));
        press(KeyEvent.VK_HOME);
        await(() -> loaded().scene().equals(again)); // the scene loaded last, not the first one
    }

    @Test
    void aFileIsReplacedOnlyIfOneSaysSo() throws Exception {
        Path file = Files.writeString(folder.resolve("kept.json"), "mine");
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        Dialogs.choose("Save scene", file);
        Dialogs.answer("Replace file", "Cancel");
        assertThat(file).hasContent("mine");
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        Dialogs.choose("Save scene", file);
        Dialogs.answer("Replace file", "OK");
        await(() -> Files.readString(file).contains("\"mesh\""));
    }

    @Test
    void theSavedPictureIsTheFinalOneAndSaysHowItWasMade() throws Exception {
        drag(InputEvent.BUTTON3_DOWN_MASK);
        Path file = folder.resolve("picture.png");
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_P);
        Dialogs.choose("Save picture", folder.resolve("picture"));
        await(() -> message().contains("picture.png"));
        awaitFinal();
        assertThat(different(ImageIO.read(file.toFile()), picture(), false)).isZero();
        assertThat(PngText.read(file))
                .containsKeys("Scene", "Patch", "Method", "Size", "Exposure", "Parameters")
                .containsEntry("Plan", loaded().method().summary())
                .hasEntrySatisfying("Renderer", name -> assertThat(name).isNotBlank());
        onEvents(() -> viewer.files().savePicture(folder.resolve("missing/picture.png")));
        await(() -> message().startsWith("cannot write"));
        assertThat(message()).contains("does not exist").doesNotContain("\n");
        assertThat(onEvents(() -> viewer.window().picture().isFinal())).isTrue();
    }
}
