package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Pick;

/** The viewer in a real window, under a robot's hands. */
final class ViewerWindowTest extends ViewerInAWindow {
    @Test
    void rightDragMovesTheLightColoursChangeAndGeometryDoesNot() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        BufferedImage after = picture();
        assertThat(shownPixels(before))
                .as("pixels of the model")
                .isBetween(100, before.getWidth() * before.getHeight() - 100);
        assertThat(spectralPixels(before)).as("pixels in diffraction colours").isGreaterThan(500);
        assertThat(different(before, after, false))
                .as("pixels of another colour")
                .isGreaterThan(500);
        assertThat(different(before, after, true))
                .as("pixels of another silhouette")
                .isZero();
    }

    @Test
    void leftDragTurnsTheModel() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON1_DOWN_MASK);
        awaitFinal();
        assertThat(different(before, picture(), true))
                .as("pixels of another silhouette")
                .isPositive();
    }

    @Test
    void theFinalPictureIsWhatRenderWritesAlsoAfterTheLightHasMoved() throws Exception {
        assertThat(picture().getWidth()).as("drawn in several tiles").isGreaterThan(2 * TileSide.LARGEST);
        assertThat(different(picture(), rendered("before"), false)).isZero();
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        assertThat(different(picture(), rendered("after"), false)).isZero();
    }

    @Test
    void shiftDragMovesTheLightTooAndTheSkinStaysWhereItIs() throws Exception {
        Pick before = doubleClick();
        robot.keyPress(KeyEvent.VK_SHIFT);
        drag(InputEvent.BUTTON1_DOWN_MASK);
        robot.keyRelease(KeyEvent.VK_SHIFT);
        awaitFinal();
        Pick after = doubleClick();
        assertThat(after.position()).isEqualTo(before.position());
        assertThat(after.normal()).isEqualTo(before.normal());
        assertThat(after.tangent()).isEqualTo(before.tangent());
        assertThat(after.wi()).as("towards the light").isNotEqualTo(before.wi());
    }

    @Test
    void wheelZoomsAndMiddleDragPans() throws Exception {
        BufferedImage before = picture();
        middle(0);
        robot.mouseWheel(-3);
        awaitFinal();
        BufferedImage near = picture();
        assertThat(shownPixels(near)).as("pixels of the model").isGreaterThan(shownPixels(before));
        drag(InputEvent.BUTTON2_DOWN_MASK);
        awaitFinal();
        assertThat(different(near, picture(), true)).isPositive();
    }
}
