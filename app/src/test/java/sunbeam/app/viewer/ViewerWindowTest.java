package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static sunbeam.app.viewer.Pictures.different;
import static sunbeam.app.viewer.Pictures.shownPixels;
import static sunbeam.app.viewer.Pictures.spectralPixels;

import java.awt.Dimension;
import java.awt.Frame;
import java.awt.event.InputEvent;
import java.awt.image.BufferedImage;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.viewer.ScenePresenter.Overlay;

/** The viewer in a real window, driven by a robot; windows that are made small, hidden, minimized and large again. */
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

    private static final SceneLight OTHER = new SceneLight(new Vector3f(-0.3f, -0.6f, -0.42f), 1);

    @Test
    void aWindowOfNoSizeGoesOnAndComesBack() throws Exception {
        BufferedImage before = picture();
        resize(1, 1);
        awaitOnEvents(() -> viewer.window.picture.pictureHeight() < 1);
        moveLight();
        resize(620, 420);
        awaitFinal();
        BufferedImage after = picture();
        assertThat(after.getWidth()).isEqualTo(onEvents(() -> viewer.window.picture.getWidth()));
        assertThat(different(before, after, false)).as("the light has moved").isGreaterThan(500);
        assertThat(different(before, after, true)).isZero();
    }

    @Test
    void aNarrowWindowOpensWithoutThePanel() throws Exception {
        Viewer narrow = Viewer.open(scene(), environment(), line -> {}, new Dimension(480, 320));
        onEvents(() -> {
            assertThat(narrow.window.panel.isVisible()).isFalse();
            assertThat(narrow.window.picture.getSize()).isEqualTo(new Dimension(480, 320));
            narrow.window.setSize(700, 500);
        });
        await(() -> onEvents(() -> narrow.window.picture.getWidth()) > 600);
        onEvents(() -> narrow.window.setSize(1180, 880));
        awaitOnEvents(() -> narrow.window.panel.isVisible());
        onEvents(() -> narrow.quit());
        narrow.awaitEnd(PATIENCE_MILLISECONDS);
    }

    @Test
    void aHiddenWindowIsDrawnAnewWhenItComesBack() throws Exception {
        BufferedImage before = picture();
        onEvents(() -> {
            viewer.window.setExtendedState(Frame.ICONIFIED);
            viewer.window.setVisible(false);
        });
        moveLight();
        onEvents(() -> {
            viewer.window.setExtendedState(Frame.NORMAL);
            viewer.window.setVisible(true);
        });
        awaitFinal();
        BufferedImage after = picture();
        assertThat(different(before, after, false)).as("the light has moved").isGreaterThan(500);
        await(() -> different(screen(viewer.window.picture), after, false) == 0);
        toggleStrokes();
        await(() -> different(screen(viewer.window.picture), after, false) > 500);
        assertThat(different(picture(), after, false))
                .as("what is saved has no strokes")
                .isZero();
        toggleStrokes();
        await(() -> different(screen(viewer.window.picture), after, false) == 0);
        drag(InputEvent.BUTTON1_DOWN_MASK);
        awaitFinal();
        assertThat(different(after, picture(), true)).isPositive();
    }

    private void toggleStrokes() throws Exception {
        onEvents(() -> viewer.presenter.toggle(Overlay.STROKES));
    }

    private void resize(int width, int height) throws Exception {
        onEvents(() -> {
            viewer.window.setMinimumSize(null);
            viewer.window.setSize(width, height);
        });
    }

    private void moveLight() throws Exception {
        change(scene -> scene.withLight(OTHER));
    }
}
