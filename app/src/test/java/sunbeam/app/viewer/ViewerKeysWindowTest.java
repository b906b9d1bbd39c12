package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.function.Predicate;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.setting.Choices;

/** What the keys do, pressed by a robot in a real window. */
@Tag("window")
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
        return onEvents(() -> {
            Scene scene = viewer.model().scene();
            return scene.view()
                    .camera()
                    .worldToCamera()
                    .transformDirection(scene.light().towards(), new Vector3f());
        });
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
    void homeGoesBackToTheSceneAsItWasLoaded() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON1_DOWN_MASK);
        drag(InputEvent.BUTTON3_DOWN_MASK);
        wheel(2);
        onEvents(() -> {
            viewer.model().change(scene -> scene.with(Choices.none().with(SceneSettings.ROTATE_PATCH, 1.0)));
            return null;
        });
        awaitFinal();
        assertThat(different(before, picture(), true)).isPositive();
        press(KeyEvent.VK_HOME);
        awaitScene(scene -> scene.equals(scene()));
        awaitFinal();
        assertThat(different(before, picture(), false)).isZero();
        // A step of its own, as is the rotation before.
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        awaitScene(scene -> scene.get(SceneSettings.ROTATE_PATCH) == 1);
        press(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        awaitScene(scene -> scene.equals(scene()));
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
