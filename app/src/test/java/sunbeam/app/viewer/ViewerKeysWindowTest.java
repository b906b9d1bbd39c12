package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

@Tag("window")
final class ViewerKeysWindowTest extends ViewerInAWindow {
    // Rounding of float32 directions after some rotations.
    private static final double ROUNDING = 1e-5;

    @Test
    void arrowsMoveTheLightByTwoDegreesAndNothingElse() throws Exception {
        Vector3f first = seenLight();
        press(KeyEvent.VK_RIGHT);
        awaitLightOther(first);
        Vector3f right = seenLight();
        assertThat(azimuth(right) - azimuth(first)).isCloseTo(Math.toRadians(2), within(ROUNDING));
        assertThat(right.y).isCloseTo(first.y, within((float) ROUNDING));
        press(KeyEvent.VK_UP);
        awaitLightOther(right);
        Vector3f up = seenLight();
        assertThat(elevation(up) - elevation(right)).isCloseTo(Math.toRadians(2), within(ROUNDING));
        assertThat(up.x).isCloseTo(right.x, within((float) ROUNDING));
        assertThat(modelScene().withLight(scene().light())).isEqualTo(scene());
        press(KeyEvent.VK_DOWN);
        awaitLightOther(up);
        press(KeyEvent.VK_LEFT);
        await(() -> seenLight().distance(first) < ROUNDING);
    }

    @Test
    void theHelpOfASmallWindowBreaksItsLinesAndScrollsOnlyVertically() throws Exception {
        onEvents(() -> viewer.window.setSize(800, 600));
        press(KeyEvent.VK_F1);
        JDialog help = Dialogs.await("Mouse and keys");
        onEvents(() -> {
            JScrollPane list = Dialogs.find(help, JScrollPane.class, any -> true);
            assertThat(list.getHorizontalScrollBar().isVisible()).isFalse();
            assertThat(list.getVerticalScrollBar().isVisible()).isTrue();
            assertThat(help.getHeight()).isLessThanOrEqualTo(600);
        });
        Dialogs.answer("Mouse and keys", "OK");
    }

    private Vector3f seenLight() throws Exception {
        Scene scene = modelScene();
        return scene.view()
                .camera()
                .worldToCamera()
                .transformDirection(scene.light().towards(), new Vector3f());
    }

    private void awaitLightOther(Vector3f light) throws Exception {
        await(() -> !seenLight().equals(light));
    }

    /** Returns the angle around the picture's vertical axis. */
    private static double azimuth(Vector3f seen) {
        return Math.atan2(seen.x, seen.z);
    }

    /** Returns the angle around the picture's horizontal axis. */
    private static double elevation(Vector3f seen) {
        return Math.atan2(seen.y, seen.z);
    }

    @Test
    void homeGoesBackToTheSceneAsItWasLoaded() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON1_DOWN_MASK);
        drag(InputEvent.BUTTON3_DOWN_MASK);
        wheel(2);
        change(scene -> scene.with(Choices.none().with(SceneSettings.ROTATE_PATCH, 1.0)));
        awaitFinal();
        assertThat(different(before, picture(), true)).isPositive();
        press(KeyEvent.VK_HOME);
        awaitScene(scene -> scene.equals(scene()));
        awaitFinal();
        assertThat(different(before, picture(), false)).isZero();
        // The light's move and the rotation are separate steps.
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        awaitScene(scene -> scene.get(SceneSettings.ROTATE_PATCH) == 1);
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        awaitScene(scene -> scene.equals(scene()));
    }

    @Test
    void undoIsGrayInAnOpenMenuUnlessSomethingHasChanged() throws Exception {
        assertThat(isUndoEnabled(true)).isFalse();
        assertThat(isUndoEnabled(false)).as("its key").isTrue();
        press(KeyEvent.VK_RIGHT);
        awaitScene(scene -> !scene.equals(scene()));
        assertThat(isUndoEnabled(true)).isTrue();
        isUndoEnabled(false);
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        awaitScene(scene -> scene.equals(scene()));
    }

    private boolean isUndoEnabled(boolean isMenuOpen) throws Exception {
        return onEvents(() -> {
            JMenu edit = viewer.window.getJMenuBar().getMenu(2);
            edit.setSelected(isMenuOpen);
            return edit.getItem(0).isEnabled();
        });
    }

    @Test
    void aMessageGoesWithItsCause() throws Exception {
        enterCoherence("15");
        assertThat(message()).contains("has no unit");
        enterCoherence("14 um");
        assertThat(message()).isBlank();
        awaitFinal();
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        await(() -> message().startsWith("nothing to copy"));
        doubleClick();
        assertThat(message()).isBlank();
    }

    private void enterCoherence(String text) throws Exception {
        onEvents(() -> {
            JTextField field = control(MethodSettings.COHERENCE_LENGTH.key(), JTextField.class);
            field.setText(text);
            field.postActionEvent();
        });
    }

    @Test
    void whileLIsHeldTheLightFollowsTheMouseWithoutAButton() throws Exception {
        Vector3f first = seenLight();
        middle(0);
        focus();
        arrivals.await(KeyEvent.KEY_PRESSED, 1, () -> robot.keyPress(KeyEvent.VK_L));
        middle(30);
        awaitLightOther(first);
        arrivals.await(KeyEvent.KEY_RELEASED, 1, () -> robot.keyRelease(KeyEvent.VK_L));
        Vector3f right = seenLight();
        PictureView view = viewer.window.picture;
        assertThat(azimuth(right) - azimuth(first))
                .as("half a turn is the shorter side")
                .isCloseTo(30 * Math.PI / Math.min(view.getWidth(), view.getHeight()), within(ROUNDING));
        middle(0);
        robot.delay(100);
        assertThat(seenLight()).isEqualTo(right);
    }

    @Test
    void turntableAndLightSweepPlayUntilTheirKeyIsPressedAgain() throws Exception {
        press(KeyEvent.VK_T);
        await(() -> onEvents(() -> viewer.model.scene().orientation().angle()) > Math.toRadians(20));
        Scene turning = modelScene();
        assertThat(turning.orientation().transform(new Vector3f(0, 0, 1)).z).isCloseTo(1, within((float) ROUNDING));
        assertThat(button("TURNTABLE")).isTrue();
        press(KeyEvent.VK_S);
        awaitScene(scene -> !scene.light().equals(turning.light()));
        assertThat(button("TURNTABLE")).as("one motion at a time").isFalse();
        assertThat(button("LIGHT_SWEEP")).isTrue();
        press(KeyEvent.VK_S);
        Scene stopped = modelScene();
        robot.delay(100);
        assertThat(modelScene()).isEqualTo(stopped);
        assertThat(button("LIGHT_SWEEP")).isFalse();
    }

    private boolean button(String name) throws Exception {
        JMenuBar bar = viewer.window.getJMenuBar();
        return onEvents(() -> Dialogs.find(bar, JToggleButton.class, button -> name.equals(button.getName()))
                .isSelected());
    }

    @Test
    void thePanelHidesAndThePictureFillsTheScreen() throws Exception {
        int beside = onEvents(() -> viewer.window.picture.getWidth());
        press(KeyEvent.VK_F9);
        await(() -> onEvents(() -> viewer.window.picture.getWidth()) > beside + 300);
        press(KeyEvent.VK_F11);
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        await(() -> onEvents(() -> viewer.window.getSize()).equals(screen));
        press(KeyEvent.VK_F11);
        await(() -> onEvents(() -> viewer.window.getWidth()) == 620);
        press(KeyEvent.VK_F9);
        await(() -> onEvents(() -> viewer.window.picture.getWidth()) == beside);
    }

    @Test
    void menusMarkWhatIsOnAndTheCurrentScene() throws Exception {
        assertThat(marked("View")).containsExactly("Show or hide the panel");
        press(KeyEvent.VK_C);
        press(KeyEvent.VK_N);
        press(KeyEvent.VK_M);
        assertThat(marked("View"))
                .containsExactly(
                        "Show or hide the panel",
                        "Show or hide the light's cone",
                        "Show or hide how the nanostructure lies",
                        "Show or hide the BRDF map");
        assertThat(marked("Scenes")).isEmpty();
        // Without its load, which takes seconds.
        onEvents(() -> viewer.sceneAsOpened = Scenes.load("light-left"));
        assertThat(marked("Scenes")).containsExactly(Scenes.load("light-left").get(SceneSettings.TITLE));
    }

    private List<String> marked(String title) throws Exception {
        return onEvents(() -> {
            JMenuBar bar = viewer.window.getJMenuBar();
            JMenu menu = Dialogs.find(
                    bar, JMenu.class, candidate -> candidate.getText().equals(title));
            menu.setSelected(true);
            menu.setSelected(false);
            return Arrays.stream(menu.getMenuComponents())
                    .map(JMenuItem.class::cast)
                    .filter(JMenuItem::isSelected)
                    .map(JMenuItem::getText)
                    .toList();
        });
    }

    @Test
    void controlQQuits() throws Exception {
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        assertThat(viewer.awaitEnd(PATIENCE_MILLISECONDS)).isTrue();
    }

    private void awaitScene(Predicate<Scene> condition) throws Exception {
        awaitOnEvents(() -> condition.test(viewer.model.scene()));
    }
}
