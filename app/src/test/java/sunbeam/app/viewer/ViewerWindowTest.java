package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static sunbeam.app.viewer.Pictures.different;
import static sunbeam.app.viewer.Pictures.shownPixels;
import static sunbeam.app.viewer.Pictures.spectralPixels;

import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.OptionalDouble;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.render.TimedTiles;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneColor;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;

/** The viewer in a real window, driven by a robot: small, hidden and large again; and another method beside the scene's own. */
@Tag("window")
final class ViewerWindowTest extends ViewerInAWindow {
    @Test
    void rightDragMovesTheLightColorsChangeAndGeometryDoesNotAndEachFinalPictureIsWhatRenderWrites() throws Exception {
        BufferedImage before = picture();
        assertThat(before.getWidth()).as("drawn in several tiles").isGreaterThan(2 * TimedTiles.LARGEST);
        assertThat(different(before, rendered("before"), false)).isZero();
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        BufferedImage after = picture();
        // The viewer keeps the exposure of the first picture, as an animation does.
        double kept = onEvents(
                () -> viewer.presenter.finished().orElseThrow().picture().exposure());
        Scene exposed = modelScene().with(SceneSettings.EXPOSURE, OptionalDouble.of(kept));
        assertThat(different(after, rendered("after", exposed), false)).isZero();
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
            assertThat(narrow.window.picture.isHintShown).isTrue();
            Action.STROKES.run(narrow, null);
            assertThat(narrow.window.picture.isHintShown).as("after a key").isFalse();
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
        change(scene -> scene.withLight(new SceneLight(new Vector3f(-0.3f, -0.6f, -0.42f), 1, 0)));
    }

    private static final int TOP_LABELS = 40;
    // Columns on either side that the line and its handle cover.
    private static final int LINE = 8;

    @Test
    void theThesisStandsToTheRightOfALineThatIsDragged() throws Exception {
        // The comparison uses the exposure of the scene's own picture.
        change(scene -> scene.with(Choices.none().with(SceneSettings.EXPOSURE, OptionalDouble.of(0.7))));
        awaitFinal();
        Scene scene = modelScene();
        BufferedImage own = picture();
        choose("comparison", "full, thesis");
        BufferedImage both = awaitOther();
        BufferedImage thesis = thesis("thesis");
        int middle = own.getWidth() / 2;
        assertSame(both, own, 0, middle - LINE);
        assertSame(both, thesis, middle + LINE, own.getWidth());
        assertThat(different(own, thesis, false)).as("the methods differ").isPositive();

        Point line = middle(0);
        arrivals.await(MouseEvent.MOUSE_RELEASED, 1, () -> {
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            robot.mouseMove(line.x + 60, line.y);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        });
        assertThat(modelScene()).as("turned by no drag of the line").isEqualTo(scene);
        BufferedImage dragged = shown();
        assertSame(dragged, own, 0, middle + 60 - LINE);
        assertSame(dragged, thesis, middle + 60 + LINE, own.getWidth());
        press(KeyEvent.VK_ALT, KeyEvent.VK_LEFT);
        await(() -> onEvents(() -> divider().share()) < 0.5 + 60.0 / own.getWidth());

        arrivals.await(KeyEvent.KEY_PRESSED, 1, () -> robot.keyPress(KeyEvent.VK_SPACE));
        await(() -> different(shown(), dragged, false) > 0);
        assertSame(shown(), thesis, LINE, own.getWidth());
        arrivals.await(KeyEvent.KEY_RELEASED, 1, () -> robot.keyRelease(KeyEvent.VK_SPACE));

        press(KeyEvent.VK_RIGHT);
        awaitOnEvents(() -> !divider().isFinal());
        awaitFinal();
        BufferedImage lit = awaitOther();
        int edge = (int) onEvents(() -> divider().share() * own.getWidth()).doubleValue();
        assertSame(lit, picture(), 0, edge - LINE);
        assertSame(lit, thesis("lit"), edge + LINE, own.getWidth());
        choose("comparison", "off");
        awaitOnEvents(() -> !divider().isFinal());
        assertSame(shown(), picture(), 0, own.getWidth());
    }

    @Test
    void bothSidesHaveTheGround() throws Exception {
        change(scene -> scene.with(Choices.none()
                .with(SceneSettings.GROUND, Optional.of(SceneColor.parse("#a0a0a0")))
                .with(SceneSettings.BACKGROUND, Optional.of(SceneColor.parse("#ff00ff")))
                .with(SceneSettings.SKY, 0.5)
                .with(SceneSettings.SHADOWS, true)));
        awaitFinal();
        choose("comparison", "full, thesis");
        BufferedImage both = awaitOther();
        int own = picture().getRGB(both.getWidth() - 1, both.getHeight() - 1);
        int other = both.getRGB(both.getWidth() - 1, both.getHeight() - 1);
        for (int shift = 0; shift < 24; shift += 8) {
            // The thesis's primaries have another white: a tenth of a channel. The background is 255, 0, 255.
            assertThat(other >> shift & 255).isCloseTo(own >> shift & 255, within(12));
        }
    }

    private BufferedImage shown() throws Exception {
        return paintedPicture();
    }

    private Divider divider() {
        return viewer.window.picture.divider;
    }

    private BufferedImage awaitOther() throws Exception {
        awaitOnEvents(() -> divider().isFinal());
        return shown();
    }

    /** Returns the picture that the command render draws with the thesis's preset. */
    private BufferedImage thesis(String name) throws Exception {
        Scene scene = modelScene();
        return rendered(
                name,
                scene.withMethod(new SceneMethod(Choices.none()
                        .with(Methods.METHOD, FullMethod.TYPE)
                        .with(MethodSettings.PRESET, Preset.THESIS)
                        .with(MethodSettings.COHERENCE_LENGTH, 15e-6))));
    }

    /** Asserts that both are equal in these columns, below the labels. */
    private static void assertSame(BufferedImage one, BufferedImage other, int from, int to) {
        int height = one.getHeight() - TOP_LABELS;
        assertThat(different(
                        one.getSubimage(from, TOP_LABELS, to - from, height),
                        other.getSubimage(from, TOP_LABELS, to - from, height),
                        false))
                .as("pixels that differ in columns %s to %s", from, to)
                .isZero();
    }
}
