package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.Thread.UncaughtExceptionHandler;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.function.UnaryOperator;
import javax.imageio.ImageIO;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import jrtr.scene.View.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.render.Pick;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneWriter;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.Weights;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.texture.Scales;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;

/** Test of a viewer in a real window, driven by a robot. A failure on any thread, such as the event thread, fails the test. */
@Timeout(300)
public abstract class ViewerInAWindow {
    static final long PATIENCE_MILLISECONDS = 60_000;
    static final int DRAG_RIGHT = 40;
    static final int DRAG_UP = 32;

    // The whole cylinder is visible, with background around it.
    private static final float EYE = 0.8f;

    @TempDir
    Path folder;

    Viewer viewer;
    Robot robot;
    Arrivals arrivals;
    private final List<Throwable> uncaught = new CopyOnWriteArrayList<>();
    private UncaughtExceptionHandler handlerBefore;

    @BeforeEach
    void open() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no DISPLAY: windows cannot be tested");
        handlerBefore = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> uncaught.add(failure));
        robot = new Robot();
        robot.setAutoDelay(10);
        arrivals = new Arrivals();
        viewer = opened();
        awaitFinal();
    }

    /** Opens the viewer. */
    Viewer opened() throws Exception {
        Viewer opened = Viewer.open(scene(), environment(), line -> {}, null);
        onEvents(() -> {
            opened.window.showPanel(true);
            opened.window.picture.hideHint();
            opened.window.setBounds(0, 0, 620, 420);
            opened.presenter.toggle(Overlay.MAP);
        });
        return opened;
    }

    /** A cylinder with the colors of a coarse grating: a silhouette that turns, and a method that takes milliseconds. */
    public static Scene scene() {
        Scene elaphe = Scenes.load("elaphe");
        Camera camera = new Camera(new Vector3f(0, -EYE, 0.7f * EYE), new Vector3f(0, 0, 0.1f), new Vector3f(0, 0, 1));
        return elaphe.withMesh(MeshSource.of("cylinder"))
                .withView(new Viewpoint(camera, Math.toRadians(30)))
                .withPatch(PatchRequest.of("blaze"))
                .with(Choices.none()
                        .with(SceneSettings.GROUND, Optional.empty())
                        .with(SceneSettings.SHADOWS, false)
                        .with(SceneSettings.SKY, 0.0)
                        .with(SceneSettings.SCALES, Scales.NONE)
                        .with(SceneSettings.ROUGHNESS, 0.0)
                        .with(Methods.METHOD, FullMethod.TYPE)
                        .with(MethodSettings.TOLERANCE, 0.05)
                        .with(MethodSettings.COHERENCE_LENGTH, 15e-6))
                .with(SceneSettings.TEXTURE, "none")
                .with(Weights.of(2000, 0.5, 0.2, 0.1))
                .withLight(new SceneLight(new Vector3f(0.3f, -0.6f, -0.42f), 1, 0));
    }

    @AfterEach
    void close() throws Exception {
        if (viewer != null) {
            onEvents(() -> viewer.quit());
            assertThat(viewer.awaitEnd(PATIENCE_MILLISECONDS)).as("ended").isTrue();
            arrivals.close();
            // Handle the last notifications of the render thread.
            onEvents(() -> null);
            // Threads that write would use the folder after its removal.
            await(() -> Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> Set.of("loading", "files", "spectrum").contains(thread.getName())));
            Thread.setDefaultUncaughtExceptionHandler(handlerBefore);
        }
        assertThat(uncaught).as("failures that nobody caught").isEmpty();
    }

    /** Moves the mouse to a point of the picture's middle row and returns it. */
    Point middle(int right) throws Exception {
        PictureView view = viewer.window.picture;
        Point corner = onEvents(view::getLocationOnScreen);
        Point point = new Point(corner.x + view.getWidth() / 2 + right, corner.y + view.getHeight() / 2);
        robot.mouseMove(point.x, point.y);
        return point;
    }

    /** Picks the point of the skin in the picture's middle. */
    @SuppressWarnings("ReferenceEquality") // another click's point, though perhaps an equal one
    Pick doubleClick() throws Exception {
        Optional<SkinPoint> before = onEvents(() -> viewer.inspector.point());
        // Far from the last click, or else this one is the third of a row.
        middle(-80);
        click(1);
        middle(0);
        click(2);
        awaitOnEvents(() -> {
            Optional<SkinPoint> now = viewer.inspector.point();
            return now.isPresent() && (before.isEmpty() || now.get() != before.get());
        });
        awaitFinal();
        return onEvents(() -> viewer.inspector.point().orElseThrow().pick());
    }

    void click(int times) throws Exception {
        arrivals.await(MouseEvent.MOUSE_CLICKED, times, () -> {
            for (int click = 0; click < times; click++) {
                robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
                robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            }
        });
    }

    void wheel(int notches) throws Exception {
        arrivals.await(MouseEvent.MOUSE_WHEEL, Math.abs(notches), () -> robot.mouseWheel(notches));
    }

    <T extends Component> T control(String name, Class<T> type) {
        return Dialogs.find(viewer.window.controls, type, control -> name.equals(control.getName()));
    }

    Environment environment() {
        return new Environment(Map.of("XDG_CACHE_HOME", folder.toString()), folder);
    }

    /** Drags from the picture's middle, {@link #DRAG_RIGHT} and {@link #DRAG_UP} pixels. */
    void drag(int button) throws Exception {
        Point from = middle(0);
        int x = from.x;
        int y = from.y;
        arrivals.await(MouseEvent.MOUSE_RELEASED, 1, () -> {
            robot.mousePress(button);
            for (int step = 1; step <= 8; step++) {
                robot.mouseMove(x + DRAG_RIGHT * step / 8, y - DRAG_UP * step / 8);
            }
            robot.mouseRelease(button);
        });
    }

    /** Waits until the picture has the focus, which it requests if there is no window manager. */
    void focus() throws Exception {
        PictureView view = viewer.window.picture;
        awaitOnEvents(() -> {
            if (!view.isFocusOwner()) {
                view.requestFocus();
            }
            return view.isFocusOwner();
        });
    }

    /** Presses keys together, such as Ctrl and S, once the picture has the focus. */
    void press(int... keys) throws Exception {
        focus();
        arrivals.await(KeyEvent.KEY_PRESSED, keys.length, () -> {
            for (int key : keys) {
                robot.keyPress(key);
            }
            for (int i = keys.length - 1; i >= 0; i--) {
                robot.keyRelease(keys[i]);
            }
        });
    }

    /** Returns the screen's pixels in a component's place. */
    BufferedImage screen(Component component) throws Exception {
        onEvents(() -> viewer.window.picture.light.opacity = 0);
        return robot.createScreenCapture(
                onEvents(() -> new Rectangle(component.getLocationOnScreen(), component.getSize())));
    }

    /** Returns a component's own painting, even if the window is too small to show it. Called on the event thread. */
    static BufferedImage painted(JComponent component) {
        BufferedImage image =
                new BufferedImage(component.getWidth(), component.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics graphics = image.createGraphics();
        component.paint(graphics);
        graphics.dispose();
        return image;
    }

    /** Returns the picture with its overlays, but for the light's handle, which fades. */
    BufferedImage paintedPicture() throws Exception {
        return onEvents(() -> {
            viewer.window.picture.light.opacity = 0;
            return painted(viewer.window.picture);
        });
    }

    /** Returns the picture that the command render writes for the viewer's scene, saved as a file. */
    BufferedImage rendered(String name) throws Exception {
        return rendered(name, modelScene());
    }

    /** Returns the picture that the command render writes for a scene, in the viewer's size. */
    BufferedImage rendered(String name, Scene scene) throws Exception {
        BufferedImage shown = picture();
        Path sceneFile = folder.resolve(name + ".json");
        SceneWriter.write(sceneFile, Overwrite.REFUSE, scene);
        Path png = folder.resolve(name + ".png");
        String command =
                "render " + sceneFile + " --size " + shown.getWidth() + "x" + shown.getHeight() + " --output " + png;
        StringWriter err = new StringWriter();
        int status = new Sunbeam(environment(), new PrintWriter(new StringWriter()), new PrintWriter(err))
                .run(command.split(" ", -1));
        assertThat(status).as(err.toString()).isZero();
        return ImageIO.read(png.toFile());
    }

    void awaitFinal() throws Exception {
        // Wait until the render loop has received the last change.
        robot.delay(100);
        awaitOnEvents(() -> {
            PictureView view = viewer.window.picture;
            return viewer.presenter.finished().isPresent()
                    && view.picture().orElseThrow().getWidth() == view.pictureWidth();
        });
    }

    void change(UnaryOperator<Scene> change) throws Exception {
        onEvents(() -> viewer.model.change(change));
    }

    Scene modelScene() throws Exception {
        return onEvents(() -> viewer.model.scene());
    }

    SceneData loaded() throws Exception {
        return onEvents(() -> viewer.model.loaded().orElseThrow().firstPart());
    }

    void choose(String name, String label) throws Exception {
        onEvents(() -> {
            JComboBox<?> box = control(name, JComboBox.class);
            for (int i = 0; i < box.getItemCount(); i++) {
                if (box.getItemAt(i).toString().equals(label)) {
                    box.setSelectedIndex(i);
                }
            }
        });
    }

    String message() throws Exception {
        return onEvents(() -> viewer.window.status.message.getText());
    }

    /** @param name a built-in patch or its file */
    void awaitPatch(String name) throws Exception {
        await(() -> loaded().scene().patch().patch().equals(name));
    }

    static void await(Callable<Boolean> condition) throws Exception {
        long last = System.currentTimeMillis();
        long waited = 0;
        while (!condition.call()) {
            assertThat(waited).as("milliseconds waited").isLessThan(PATIENCE_MILLISECONDS);
            Thread.sleep(20);
            long now = System.currentTimeMillis();
            // Do not count time during which the machine was suspended.
            waited += Math.min(1000, now - last);
            last = now;
        }
    }

    BufferedImage picture() throws Exception {
        return onEvents(() -> viewer.window.picture.picture().orElseThrow());
    }

    /** Work on the event thread that may throw. */
    interface Work {
        void run() throws Exception;
    }

    static void onEvents(Work work) throws Exception {
        onEvents(() -> {
            work.run();
            return null;
        });
    }

    static void awaitOnEvents(Callable<Boolean> condition) throws Exception {
        await(() -> onEvents(condition));
    }

    static <T> T onEvents(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeLater(task);
        return task.get();
    }
}
