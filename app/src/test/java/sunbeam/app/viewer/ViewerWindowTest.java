package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;
import static sunbeam.app.viewer.Pictures.shownPixels;
import static sunbeam.app.viewer.Pictures.spectralPixels;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Pick;

/** The viewer in a real window, under a robot's hands. */
final class ViewerWindowTest extends ViewerInAWindow {
    @Test
    void rightDragMovesTheLightColorsChangeAndGeometryDoesNot() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        BufferedImage after = picture();
        assertThat(shownPixels(before))
                .as("pixels of the model")
                .isBetween(100, before.getWidth() * before.getHeight() - 100);
        assertThat(spectralPixels(before)).as("pixels in diffraction colors").isGreaterThan(500);
        assertThat(different(before, after, false))
                .as("pixels of another color")
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
        wheel(-3);
        awaitFinal();
        BufferedImage near = picture();
        assertThat(shownPixels(near)).as("pixels of the model").isGreaterThan(shownPixels(before));
        drag(InputEvent.BUTTON2_DOWN_MASK);
        awaitFinal();
        assertThat(different(near, picture(), true)).isPositive();
    }

    @Test
    void theSkinFollowsAMiddleDrag() throws Exception {
        double[] before = middleOfModel(picture());
        drag(InputEvent.BUTTON2_DOWN_MASK);
        awaitFinal();
        double[] after = middleOfModel(picture());
        // Nearer parts of the cylinder move farther, and are seen from another side: a tenth of the distance from the
        // eye.
        assertThat(after[0] - before[0]).as("columns").isCloseTo(DRAG_RIGHT, within(0.1 * DRAG_RIGHT));
        assertThat(before[1] - after[1]).as("rows upwards").isCloseTo(DRAG_UP, within(0.1 * DRAG_UP));
    }

    /** Mean column and row of the pixels that are not background. */
    private static double[] middleOfModel(BufferedImage image) {
        int background = 0xff000000 | scene().background().rgb();
        double columns = 0;
        double rows = 0;
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                if (image.getRGB(x, y) != background) {
                    columns += x;
                    rows += y;
                    count++;
                }
            }
        }
        return new double[] {columns / count, rows / count};
    }
}
