package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import jrtr.GraphicsException;
import jrtr.scene.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.Sunbeam;
import sunbeam.app.cli.Environment;
import sunbeam.app.output.Overwrite;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.Viewpoint;
import sunbeam.precompute.patch.PatchRequest;

/** The viewer in a real window, under a robot's hands. */
@Timeout(120)
final class ViewerWindowTest {
    private static final long PATIENCE_MILLISECONDS = 60_000;

    // Far enough to see all of the cylinder with background around it.
    private static final float EYE = 0.8f;

    @TempDir
    private Path folder;

    private Viewer viewer;
    private Robot robot;

    @BeforeEach
    void open() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no DISPLAY: windows cannot be tested");
        robot = new Robot();
        robot.setAutoDelay(10);
        viewer = ViewerStart.open(scene(), environment(), line -> {});
        onEvents(() -> {
            viewer.window().setBounds(0, 0, 620, 420);
            viewer.toggleMap();
            return null;
        });
        awaitFinal();
    }

    /** A cylinder of a coarse grating: a silhouette that turns, and a method that takes milliseconds. */
    private static Scene scene() {
        Scene elaphe = Scenes.load("elaphe");
        Camera camera = new Camera(new Vector3f(0, -EYE, 0.7f * EYE), new Vector3f(0, 0, 0.1f), new Vector3f(0, 0, 1));
        return elaphe.withMesh("cylinder")
                .withView(new Viewpoint(camera, Math.toRadians(30)))
                .withPatch(PatchRequest.of("blaze"))
                .withPlan(PlanChange.tolerance(elaphe.plan(), 0.05))
                .withTexture("none")
                .withBlend(new Blend(30, 0.5, 0.9, 0.1))
                .withLight(new SceneLight(new Vector3f(0.3f, 0.25f, 0.9f), 1));
    }

    @AfterEach
    void close() throws Exception {
        if (viewer != null) {
            onEvents(() -> {
                viewer.quit();
                return null;
            });
            viewer.awaitEnd(PATIENCE_MILLISECONDS);
        }
    }

    @Test
    void rightDragMovesTheLightColoursChangeAndGeometryDoesNot() throws Exception {
        BufferedImage before = picture();
        drag(InputEvent.BUTTON3_DOWN_MASK);
        awaitFinal();
        BufferedImage after = picture();
        assertThat(shownPixels(before))
                .as("pixels of the model")
                .isBetween(100, before.getWidth() * before.getHeight() - 100);
        assertThat(different(before, after, false))
                .as("pixels of another colour")
                .isPositive();
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

    /** What the command render writes for the viewer's scene, saved as a file, in the picture's size. */
    private BufferedImage rendered(String name) throws Exception {
        BufferedImage shown = picture();
        Path sceneFile = folder.resolve(name + ".json");
        SceneWriter.write(
                sceneFile, Overwrite.REFUSE, onEvents(() -> viewer.model().scene()));
        Path png = folder.resolve(name + ".png");
        StringWriter err = new StringWriter();
        int status = new Sunbeam(environment(), new PrintWriter(new StringWriter()), new PrintWriter(err))
                .run(
                        "render",
                        sceneFile.toString(),
                        "--size",
                        shown.getWidth() + "x" + shown.getHeight(),
                        "--output",
                        png.toString());
        assertThat(status).as(err.toString()).isZero();
        return ImageIO.read(png.toFile());
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

    @Test
    void methodsAreChosenInThePanelAndOneThatCannotBeUsedIsRefused() throws Exception {
        BufferedImage full = picture();
        for (MethodChoice choice : new MethodChoice[] {MethodChoice.NMM, MethodChoice.PQ_LINEAR, MethodChoice.GEM}) {
            onEvents(() -> {
                control("method", JComboBox.class).setSelectedItem(choice);
                return null;
            });
            await(() -> onEvents(() ->
                    MethodChoice.of(viewer.model().loaded().orElseThrow().fine().scene()) == choice));
            awaitFinal();
        }
        assertThat(different(full, picture(), false)).as("gem is another model").isPositive();
        onEvents(() -> {
            JTextField spacing = control("spacing", JTextField.class);
            spacing.setText("2 parsec");
            spacing.postActionEvent();
            return null;
        });
        assertThat(onEvents(() -> viewer.window().status().text())).contains("spacing of the lines", "parsec");
    }

    @Test
    void everyControlHasATooltip() throws Exception {
        onEvents(() -> {
            for (Component child : viewer.window().controls().getComponents()) {
                assertThat(((JComponent) child).getToolTipText())
                        .as("%s", child)
                        .isNotBlank();
            }
            return null;
        });
    }

    @Test
    void withoutOpenGLALabelSaysWhy() throws Exception {
        Viewer blind = onEvents(() -> {
            Viewer made = new Viewer(scene(), (next, previous) -> null, () -> {
                throw new GraphicsException("no OpenGL 3.3 here");
            });
            made.start();
            return made;
        });
        assertThatThrownBy(() -> blind.firstPicture().await()).hasMessageContaining("no OpenGL 3.3 here");
        onEvents(() -> {
            JLabel label = (JLabel) blind.window().picture().getComponent(0);
            assertThat(label.isVisible()).isTrue();
            assertThat(label.getText()).contains("no OpenGL 3.3 here");
            blind.quit();
            return null;
        });
        blind.awaitEnd(PATIENCE_MILLISECONDS);
    }

    @Test
    void aMeasurementDragsTheLightAndReports() throws Exception {
        Scene before = onEvents(() -> viewer.model().scene());
        assertThat(ViewMeasurement.of(viewer, 1)).contains("frames per second", "from input to screen");
        assertThat(onEvents(() -> viewer.model().scene()).light()).isNotEqualTo(before.light());
    }

    @Test
    void aPatchThatFailsToLoadLeavesTheOldOneAndSaysWhy() throws Exception {
        Path missing = folder.resolve("missing.json");
        onEvents(() -> {
            viewer.files().loadPatch(missing);
            return null;
        });
        await(() -> onEvents(() -> viewer.model().scene().patch().patch().equals("blaze")));
        awaitFinal();
        assertThat(onEvents(() -> viewer.window().status().text())).contains("missing.json");
    }

    @Test
    void aWindowOfNoSizeAndAMinimisedOneComeBack() throws Exception {
        onEvents(() -> {
            viewer.window().setMinimumSize(null);
            viewer.window().setSize(1, 1);
            return null;
        });
        robot.delay(300);
        onEvents(() -> {
            viewer.window().setExtendedState(Frame.ICONIFIED);
            return null;
        });
        robot.delay(200);
        onEvents(() -> {
            viewer.window().setExtendedState(Frame.NORMAL);
            viewer.window().setSize(560, 380);
            return null;
        });
        robot.delay(300);
        awaitFinal();
        assertThat(picture().getWidth())
                .isEqualTo(onEvents(() -> viewer.window().picture().getWidth()));
    }

    @Test
    void closedDuringAComputationItEndsAtTheNextTile() throws Exception {
        onEvents(() -> {
            viewer.window().setSize(1100, 800);
            viewer.model().change(scene -> scene.withPlan(PlanChange.tolerance(scene.plan(), 1e-4)));
            return null;
        });
        robot.delay(400);
        onEvents(() -> {
            viewer.quit();
            return null;
        });
        viewer.awaitEnd(PATIENCE_MILLISECONDS);
        assertThat(viewer.hasEnded()).isTrue();
    }

    /** Moves the mouse to a point of the picture's middle row and returns it. */
    private Point middle(int right) throws Exception {
        PictureView view = viewer.window().picture();
        Point corner = onEvents(view::getLocationOnScreen);
        Point point = new Point(corner.x + view.getWidth() / 2 + right, corner.y + view.getHeight() / 2);
        robot.mouseMove(point.x, point.y);
        return point;
    }

    /** Picks the point of the skin in the picture's middle. */
    private Pick doubleClick() throws Exception {
        // Far from the last click, or else this one is the third of a row.
        middle(-80);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        middle(0);
        for (int click = 0; click < 2; click++) {
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        }
        robot.waitForIdle();
        awaitFinal();
        await(() -> onEvents(() -> viewer.inspector().point().isPresent()));
        return onEvents(() -> viewer.inspector().point().orElseThrow().pick());
    }

    private <T extends Component> T control(String name, Class<T> type) {
        for (Component child : viewer.window().controls().getComponents()) {
            if (name.equals(child.getName())) {
                return type.cast(child);
            }
        }
        throw new AssertionError("there is no control " + name);
    }

    private Environment environment() {
        return new Environment(Map.of("XDG_CACHE_HOME", folder.toString()), folder);
    }

    private void drag(int button) throws Exception {
        Point from = middle(0);
        int x = from.x;
        int y = from.y;
        robot.mousePress(button);
        for (int step = 1; step <= 8; step++) {
            robot.mouseMove(x + 5 * step, y - 4 * step);
        }
        robot.mouseRelease(button);
        robot.waitForIdle();
    }

    private void awaitFinal() throws Exception {
        // A change that has just been made needs a moment to be taken up: the loop waits 150 ms for more of them.
        robot.delay(100);
        await(() -> onEvents(() -> {
            PictureView view = viewer.window().picture();
            return view.isFinal()
                    && viewer.isSettled()
                    && view.picture().orElseThrow().getWidth() == view.pictureWidth();
        }));
    }

    private static void await(Callable<Boolean> condition) throws Exception {
        long end = System.currentTimeMillis() + PATIENCE_MILLISECONDS;
        while (!condition.call()) {
            assertThat(System.currentTimeMillis()).as("waited too long").isLessThan(end);
            Thread.sleep(20);
        }
    }

    private BufferedImage picture() throws Exception {
        return onEvents(() -> viewer.window().picture().picture().orElseThrow());
    }

    /** Pixels that differ, in colour or in whether they show the background. */
    private static int different(BufferedImage one, BufferedImage other, boolean silhouette) {
        assertThat(other.getWidth()).isEqualTo(one.getWidth());
        assertThat(other.getHeight()).isEqualTo(one.getHeight());
        int background = 0xff000000 | scene().background().rgb();
        int count = 0;
        for (int y = 0; y < one.getHeight(); y++) {
            for (int x = 0; x < one.getWidth(); x++) {
                int a = one.getRGB(x, y);
                int b = other.getRGB(x, y);
                boolean differs = silhouette ? (a == background) != (b == background) : a != b;
                count += differs ? 1 : 0;
            }
        }
        return count;
    }

    private static int shownPixels(BufferedImage image) {
        BufferedImage empty = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_RGB);
        int background = scene().background().rgb();
        for (int i = 0; i < empty.getWidth() * empty.getHeight(); i++) {
            empty.setRGB(i % empty.getWidth(), i / empty.getWidth(), background);
        }
        return different(image, empty, true);
    }

    private static <T> T onEvents(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeLater(task);
        return task.get();
    }
}
