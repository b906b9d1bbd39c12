package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;
import static sunbeam.app.viewer.Pictures.shownPixels;

import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JTextField;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.precompute.plan.MethodSettings;

/** What the keys do, pressed by a robot in a real window. */
final class ViewerKeysWindowTest extends ViewerInAWindow {
    // Of directions in float32, after some rotations.
    private static final double ROUNDING = 1e-5;

    @Test
    void arrowsMoveTheLightByTwoDegreesAndNothingElse() throws Exception {
        BufferedImage before = picture();
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
        awaitFinal();
        assertThat(different(before, picture(), false))
                .as("pixels of another color")
                .isPositive();
        assertThat(different(before, picture(), true))
                .as("pixels of another silhouette")
                .isZero();
        press(KeyEvent.VK_DOWN);
        awaitLightOther(up);
        press(KeyEvent.VK_LEFT);
        await(() -> seenLight().distance(first) < ROUNDING);
    }

    private Vector3f seenLight() throws Exception {
        return onEvents(() -> MapLight.seen(viewer.model().scene()));
    }

    private void awaitLightOther(Vector3f light) throws Exception {
        await(() -> !seenLight().equals(light));
    }

    /** Around the picture's vertical axis. */
    private static double azimuth(Vector3f seen) {
        return Math.atan2(seen.x, seen.z);
    }

    /** Around the picture's horizontal axis. */
    private static double elevation(Vector3f seen) {
        return Math.atan2(seen.y, seen.z);
    }

    @Test
    void plusAndMinusZoom() throws Exception {
        BufferedImage before = picture();
        for (int step = 0; step < 3; step++) {
            press(KeyEvent.VK_EQUALS);
        }
        awaitScene(scene -> distance(scene) < 0.8 * distance(scene()));
        awaitFinal();
        assertThat(shownPixels(picture())).as("nearer").isGreaterThan(shownPixels(before));
        for (int step = 0; step < 3; step++) {
            press(KeyEvent.VK_MINUS);
        }
        awaitScene(scene -> Math.abs(distance(scene) - distance(scene())) < ROUNDING);
        press(KeyEvent.VK_MINUS);
        awaitScene(scene -> distance(scene) > 1.05 * distance(scene()));
        awaitFinal();
        assertThat(shownPixels(picture())).as("farther").isLessThan(shownPixels(before));
        press(KeyEvent.VK_SHIFT, KeyEvent.VK_EQUALS);
        awaitScene(scene -> Math.abs(distance(scene) - distance(scene())) < ROUNDING);
    }

    private static double distance(Scene scene) {
        var camera = scene.view().camera();
        return camera.centerOfProjection().distance(camera.lookAtPoint());
    }

    @Test
    void lHidesAndShowsTheCone() throws Exception {
        BufferedImage bare = picture();
        await(() -> different(screen(viewer.window().picture()), bare, false) > 0);
        press(KeyEvent.VK_L);
        await(() -> different(screen(viewer.window().picture()), bare, false) == 0);
        press(KeyEvent.VK_L);
        await(() -> lampIsOnScreen(bare));
    }

    /** Whether the pixel in the middle of the cone's opening has become yellower. */
    private boolean lampIsOnScreen(BufferedImage bare) throws Exception {
        Vector3f seen = seenLight();
        double reach = 0.4 * Math.min(bare.getWidth(), bare.getHeight());
        int x = (int) (0.5 * bare.getWidth() + reach * seen.x);
        int y = (int) (0.5 * bare.getHeight() - reach * seen.y);
        int shown = screen(viewer.window().picture()).getRGB(x, y);
        return yellow(shown) > yellow(bare.getRGB(x, y)) + 30;
    }

    private static int yellow(int rgb) {
        return (rgb >> 16 & 255) + (rgb >> 8 & 255) - 2 * (rgb & 255);
    }

    @Test
    void mShowsAndHidesTheMap() throws Exception {
        assertThat(isMapShown()).isFalse();
        press(KeyEvent.VK_M);
        await(this::isMapShown);
        awaitFinal();
        await(() -> onEvents(() -> brightPixels(painted(viewer.window().map()))) > 50);
        press(KeyEvent.VK_M);
        await(() -> !isMapShown());
    }

    /** Pixels of the map's disc that are no part of its black ground. */
    private static int brightPixels(BufferedImage map) {
        int count = 0;
        double centerX = 0.5 * map.getWidth();
        for (int y = 0; y < map.getHeight() - MapView.CAPTION; y++) {
            for (int x = 0; x < map.getWidth(); x++) {
                double radius = 0.5 * (map.getHeight() - MapView.CAPTION);
                boolean inside = Math.hypot(x - centerX, y - radius) < 0.95 * radius;
                count += inside && (map.getRGB(x, y) & 0xffffff) > 0x202020 ? 1 : 0;
            }
        }
        return count;
    }

    private boolean isMapShown() throws Exception {
        return onEvents(() -> viewer.window().map().isShowing());
    }

    @Test
    void homeGoesBackToTheSceneAsItWasLoaded() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON1_DOWN_MASK);
        drag(InputEvent.BUTTON3_DOWN_MASK);
        wheel(2);
        onEvents(() -> {
            viewer.model().change(scene -> scene.withRotatePatch(1));
            return null;
        });
        awaitFinal();
        assertThat(different(before, picture(), true)).isPositive();
        press(KeyEvent.VK_HOME);
        awaitScene(scene -> scene.equals(scene()));
        awaitFinal();
        assertThat(different(before, picture(), false)).isZero();
    }

    @Test
    void f1ShowsAListThatNamesEveryKeyOfTheMenus() throws Exception {
        press(KeyEvent.VK_F1);
        JDialog list = Dialogs.await("Mouse and keys");
        String text = onEvents(() -> Dialogs.all(list.getContentPane(), JLabel.class).stream()
                .map(JLabel::getText)
                .filter(line -> line != null)
                .reduce("", String::concat));
        for (String key : onEvents(this::menuKeys)) {
            assertThat(text).contains("<b>" + key + "</b>");
        }
        assertThat(text).contains("Left drag", "Right drag", "Middle drag", "Wheel, + and -", "Arrow keys");
        robot.keyPress(KeyEvent.VK_ESCAPE);
        robot.keyRelease(KeyEvent.VK_ESCAPE);
        await(() -> onEvents(() -> !list.isShowing()));
    }

    private List<String> menuKeys() {
        var bar = viewer.window().getJMenuBar();
        var keys = new ArrayList<String>();
        for (int m = 0; m < bar.getMenuCount(); m++) {
            JMenu menu = bar.getMenu(m);
            for (int i = 0; i < menu.getItemCount(); i++) {
                var stroke = menu.getItem(i).getAccelerator();
                boolean control = (stroke.getModifiers() & InputEvent.CTRL_DOWN_MASK) != 0;
                keys.add((control ? "Ctrl+" : "") + KeyEvent.getKeyText(stroke.getKeyCode()));
            }
        }
        assertThat(keys).isNotEmpty();
        return keys;
    }

    @Test
    void lettersTypedIntoAFieldAreNotTakenForKeysOfTheMenus() throws Exception {
        JTextField field = control("coherence", JTextField.class);
        Point corner = onEvents(field::getLocationOnScreen);
        robot.mouseMove(corner.x + 20, corner.y + 8);
        click(3); // all of the text
        await(() -> onEvents(field::isFocusOwner));
        for (int key : new int[] {KeyEvent.VK_5, KeyEvent.VK_0, KeyEvent.VK_U, KeyEvent.VK_M}) {
            robot.keyPress(key);
            robot.keyRelease(key);
        }
        await(() -> onEvents(() -> field.getText().equals("50um")));
        assertThat(isMapShown()).as("M was meant for the field").isFalse();
        robot.keyPress(KeyEvent.VK_ENTER);
        robot.keyRelease(KeyEvent.VK_ENTER);
        awaitScene(scene -> scene.method().get(MethodSettings.COHERENCE_LENGTH) == 50e-6);
    }

    @Test
    void controlQQuits() throws Exception {
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        viewer.awaitEnd(PATIENCE_MILLISECONDS);
        assertThat(viewer.hasEnded()).isTrue();
    }

    private void awaitScene(Predicate<Scene> condition) throws Exception {
        await(() -> onEvents(() -> condition.test(viewer.model().scene())));
    }
}
