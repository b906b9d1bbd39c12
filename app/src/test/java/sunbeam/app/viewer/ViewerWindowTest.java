package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.viewer.Pictures.different;
import static sunbeam.app.viewer.Pictures.shownPixels;
import static sunbeam.app.viewer.Pictures.spectralPixels;

import java.awt.event.InputEvent;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.render.TimedTiles;

/** The viewer in a real window, driven by a robot. */
@Tag("window")
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
    void theFinalPictureIsWhatRenderWritesAlsoAfterTheLightHasMoved() throws Exception {
        assertThat(picture().getWidth()).as("drawn in several tiles").isGreaterThan(2 * TimedTiles.LARGEST);
        assertThat(different(picture(), rendered("before"), false)).isZero();
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        assertThat(different(picture(), rendered("after"), false)).isZero();
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
}
