package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.cli.InspectCommand;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.setting.Choices;

/** Patches, scenes and pictures: loaded, dropped and saved through the window's keys and dialogs. */
@Tag("window")
final class ViewerPatchWindowTest extends ViewerInAWindow {
    @Test
    void aPatchIsLoadedWhileTheOldPictureIsDimmedAndNotFinalAndThePictureFollows() throws Exception {
        BufferedImage before = picture();
        int panelBefore = onEvents(() -> viewer.window.controls.getWidth());
        Path file = Pictures.descriptor(folder, "waves");
        onEvents(() -> {
            int bright = brightness(painted(viewer.window.picture));
            viewer.files.loadPatch(file);
            // Nothing is loaded yet, since results come back on this thread.
            assertThat(label("status").getText()).startsWith("Loading waves.json");
            assertThat(viewer.presenter.finished()).isEmpty();
            assertThat(brightness(painted(viewer.window.picture))).isLessThan(bright);
        });
        awaitPatch(file.toString());
        awaitFinal();
        assertThat(different(before, picture(), false))
                .as("pixels of another color")
                .isGreaterThan(500);
        assertThat(different(before, picture(), true))
                .as("pixels of another silhouette")
                .isZero();
        assertThat(different(picture(), rendered("dropped"), false))
                .as("render's picture")
                .isZero();
        assertThat(onEvents(() -> control("patch", JComboBox.class).getSelectedItem()))
                .isEqualTo(file.toString());
        assertThat(onEvents(() -> label("status").getText())).startsWith("Final");
        assertThat(isBusy()).isFalse();
        assertThat(onEvents(() -> viewer.window.controls.getWidth()))
                .as("columns of the panel, whatever the file's name")
                .isEqualTo(panelBefore);
    }

    @Test
    void remarksAboutAPatchStandBesideItsNameAndNotInTheMessage() throws Exception {
        assertThat(onEvents(() -> caption().getText())).isEqualTo("Patch");
        Pictures.image(folder, "coarse.png");
        // The image has 8 bits, so one gray level is 4 nm.
        Path file = Files.writeString(folder.resolve("coarse.json"), descriptor("coarse.png", "2 um"));
        load(file);
        awaitPatch(file.toString());
        assertThat(onEvents(() -> caption().getText())).isEqualTo("Patch (i)");
        assertThat(onEvents(() -> caption().getToolTipText())).contains("coarse: ", "slopes");
        assertThat(message()).isBlank();
        onEvents(() -> {
            JLabel caption = caption();
            caption.dispatchEvent(
                    new MouseEvent(caption, MouseEvent.MOUSE_PRESSED, 0, InputEvent.BUTTON1_DOWN_MASK, 1, 1, 1, false));
        });
        assertThat(message()).contains("coarse: ", "slopes");
    }

    @Test
    void anOpenedScanIsShownAsInspectDrawsIt() throws Exception {
        Path file = Pictures.descriptor(folder, "waves");
        Path written = folder.resolve("inspected.png");
        PrintWriter nowhere = new PrintWriter(new StringWriter());
        assertThat(new Sunbeam(environment(), nowhere, nowhere)
                        .run("inspect", file.toString(), "--output", written.toString()))
                .isZero();
        List<BufferedImage> drawn = new ArrayList<>();
        onEvents(() -> viewer.inspections.inspection = Optional.of((patch, period) -> {
            Drawing drawing = InspectCommand.picture(patch, period);
            drawn.add(drawing.rasterize());
            return drawing;
        }));

        load(file);

        JDialog shown = Dialogs.await("Inspection of waves");
        assertThat(drawn).hasSize(1);
        assertThat(different(ImageIO.read(written.toFile()), drawn.get(0), false))
                .isZero();
        onEvents(shown::dispose);
    }

    private JLabel caption() {
        return Dialogs.find(
                viewer.window.controls, JLabel.class, label -> label.getText().startsWith("Patch"));
    }

    @Test
    void brokenPatchesLeaveTheOldOneAndThePictureAndSayWhy() throws Exception {
        BufferedImage before = picture();
        refused("no.json", "{}", "heights");
        refused("words.json", "heights: none", "words.json");
        refused("gone.json", descriptor("gone.png", "3 um"), "gone.png");
        refused("unit.json", descriptor("gone.png", "3 parsec"), "gone.png");
        refused("image.json", descriptor("image.json", "3 um"), "image.json");
        Path folderItself = Files.createDirectory(folder.resolve("folder.json"));
        Path saved = folder.resolve("saved.png");
        load(folderItself);
        awaitComplaint("folder.json", "folder.json");
        // The complaint is soon replaced by "saved", so it is not awaited here.
        onEvents(() -> {
            viewer.files.loadPatch(folderItself);
            viewer.files.savePicture(saved);
        });
        await(() -> Files.exists(saved));
        awaitFinal();
        assertThat(modelScene()).isEqualTo(scene());
        assertThat(onEvents(() -> control("patch", JComboBox.class).getSelectedItem()))
                .isEqualTo("blaze");
        assertThat(different(before, picture(), false)).isZero();
    }

    @Test
    void anImageIsAskedForItsScale() throws Exception {
        Path file = Pictures.image(folder, "waves.png");
        SwingUtilities.invokeLater(() -> viewer.files.loadPatch(file));
        Dialogs.answer("Scale of waves.png", "Cancel");
        assertThat(modelScene()).isEqualTo(scene());
        SwingUtilities.invokeLater(() -> viewer.files.loadPatch(file));
        JDialog asking = Dialogs.await("Scale of waves.png");
        awaitOnEvents(() ->
                asking.getFocusOwner() == Dialogs.all(asking, JTextField.class).get(0));
        robot.keyPress(KeyEvent.VK_2);
        robot.keyRelease(KeyEvent.VK_2);
        robot.keyPress(KeyEvent.VK_SPACE); // would press a button
        robot.keyRelease(KeyEvent.VK_SPACE);
        awaitOnEvents(
                () -> Dialogs.all(asking, JTextField.class).get(0).getText().equals("2 "));
        Dialogs.type("Scale of waves.png", "2 um", "300");
        Dialogs.answer("Scale of waves.png", "OK");
        JDialog again = Dialogs.await("Scale of waves.png");
        onEvents(() -> {
            Dialogs.find(again, JTextField.class, field -> field.getText().equals("2 um"));
            Dialogs.find(again, JLabel.class, label -> label.getText().contains("has no unit"));
        });
        Dialogs.type("Scale of waves.png", "2 um", "300 nm");
        Dialogs.answer("Scale of waves.png", "OK");
        awaitPatch(file.toString());
        assertThat(loaded().patch().heights().pitchX()).isCloseTo(2e-6 / 32, within(1e-15));
    }

    private static String descriptor(String heights, String width) {
        return "{\"heights\": \"%s\", \"width\": \"%s\", \"maxHeight\": \"1 um\"}".formatted(heights, width);
    }

    private void refused(String name, String content, String reason) throws Exception {
        Path file = Files.writeString(folder.resolve(name), content);
        load(file);
        awaitComplaint(name, reason);
    }

    private void awaitComplaint(String name, String reason) throws Exception {
        await(() -> message().contains(name) && message().contains(reason) && !isBusy());
    }

    private static int brightness(BufferedImage image) {
        return Arrays.stream(Pictures.pixels(image))
                .map(rgb -> (rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255))
                .sum();
    }

    private void load(Path file) throws Exception {
        onEvents(() -> viewer.files.loadPatch(file));
    }

    private JLabel label(String name) {
        return Dialogs.find(viewer.window.status, JLabel.class, label -> name.equals(label.getName()));
    }

    private boolean isBusy() throws Exception {
        return onEvents(() -> label("status").getText()).startsWith("Loading");
    }

    @Test
    void aSceneThatIsSavedAndLoadedAgainShowsTheSamePicture() throws Exception {
        Path patch = Pictures.descriptor(folder, "waves");
        onEvents(() -> {
            viewer.files.loadPatch(patch);
            viewer.model.change(scene -> scene.with(Choices.none().with(SceneSettings.ROTATE_PATCH, 0.3))
                    .with(SceneSettings.TEXTURE, "elaphe"));
        });
        await(() -> loaded().suits(modelScene()));
        drag(InputEvent.BUTTON1_DOWN_MASK);
        drag(InputEvent.BUTTON3_DOWN_MASK);
        onEvents(() -> viewer.model.meter()); // as a scene that is opened is
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
        assertThat(onEvents(() -> viewer.files.recent.files())).containsExactly(folder.resolve("mine.json"));
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
        onEvents(() -> viewer.files.savePicture(folder.resolve("missing/picture.png")));
        await(() -> message().startsWith("cannot write"));
        assertThat(message()).contains("does not exist").doesNotContain("\n");
        assertThat(onEvents(() -> viewer.presenter.finished())).isPresent();
    }
}
