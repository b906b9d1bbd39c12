package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JTextArea;
import org.joml.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import sunbeam.app.render.LightCone;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.MeshSource;

/** The viewer of an exhibition, in a real window, by touches that arrive as those of a mouse. */
@Tag("window")
final class KioskWindowTest extends ViewerInAWindow {
    private Path mesh;

    @Override
    Viewer opened() throws Exception {
        mesh = Files.writeString(folder.resolve("square.obj"), """
                v -0.1 -0.1 0.1
                v 0.1 -0.1 0.1
                v 0.1 0.1 0.1
                v -0.1 0.1 0.1
                f 1 2 3 4
                """);
        Viewer opened = Viewer.openKiosk(scene().withMesh(MeshSource.of(mesh.toString())), environment(), line -> {});
        onEvents(() -> opened.window.setBounds(0, 0, 640, 480));
        return opened;
    }

    private List<JButton> buttons() {
        List<JButton> found = new ArrayList<>();
        collect(viewer.window.getContentPane(), found);
        return found;
    }

    private static void collect(Container container, List<JButton> found) {
        for (Component part : container.getComponents()) {
            if (part instanceof JButton button
                    && button.isShowing()
                    && !button.getName().isEmpty()) {
                found.add(button);
            } else if (part instanceof Container inner) {
                collect(inner, found);
            }
        }
    }

    private JButton button(String name) {
        return buttons().stream()
                .filter(button -> name.equals(button.getName()))
                .findFirst()
                .orElseThrow();
    }

    private String caption() throws Exception {
        return onEvents(() -> Dialogs.find(
                        viewer.window, JTextArea.class, area -> "kiosk caption".equals(area.getName()))
                .getText());
    }

    @Test
    void aVisitorMovesTheLightPicksZoomsAndLeaves() throws Exception {
        onEvents(() -> {
            viewer.presenter.verdict = " ";
            viewer.inspector.describe();
        });
        assertThat(caption())
                .as("before the verdict")
                .isEqualTo(modelScene().get(SceneSettings.TITLE))
                .isNotBlank();
        onEvents(() -> {
            assertThat(viewer.window.isUndecorated()).isTrue();
            assertThat(viewer.window.getJMenuBar()).isNull();
            assertThat(viewer.window.panel.isVisible()).isFalse();
            assertThat(buttons()).hasSize(6).allSatisfy(button -> {
                assertThat(button.getWidth()).isGreaterThanOrEqualTo(44);
                assertThat(button.getHeight()).isGreaterThanOrEqualTo(44);
            });
        });
        awaitFinal();
        Scene opening = modelScene();

        dragTheSun();
        awaitOnEvents(() -> !viewer.model.scene().light().equals(opening.light()));
        Vector3f seen = opening.view()
                .camera()
                .worldToCamera()
                .transformDirection(modelScene().light().towards(), new Vector3f());
        // Half of the handle's length to the right of the middle; a pixel is less than 0.01 of it.
        assertThat(seen.x).isCloseTo(0.5f, within(0.01f));
        assertThat(seen.y).isCloseTo(0, within(0.01f));

        middle(0);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        awaitOnEvents(() -> viewer.inspector.point().isPresent());
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        await(() -> caption().contains("light at"));

        // Two buttons at once, as by a finger and a mouse.
        drag(InputEvent.BUTTON1_DOWN_MASK | InputEvent.BUTTON3_DOWN_MASK);
        onEvents(() -> button("+").doClick());
        assertThat(modelScene().view()).isNotEqualTo(opening.view());
        rest();
        awaitOnEvents(() -> viewer.model.scene().equals(opening));
        assertThat(onEvents(() -> viewer.inspector.point())).isEmpty();
    }

    private void dragTheSun() throws Exception {
        PictureView view = viewer.window.picture;
        Point corner = onEvents(view::getLocationOnScreen);
        Point sun = onEvents(() -> {
            var at = LightCone.of(viewer.model.scene()).mouth(view.getWidth(), view.getHeight());
            return new Point((int) Math.round(at.getX()), (int) Math.round(at.getY()));
        });
        robot.mouseMove(corner.x + sun.x, corner.y + sun.y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        double length = LightCone.LENGTH * Math.min(view.getWidth(), view.getHeight());
        middle((int) Math.round(0.25 * length));
        middle((int) Math.round(0.5 * length));
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    private void rest() throws Exception {
        onEvents(() -> {
            viewer.kiosk.orElseThrow().rest.setInitialDelay(300);
            viewer.kiosk.orElseThrow().rest.restart();
        });
    }

    @Test
    void anOpeningSceneWhoseMeshHasGoneIsOneMessageAndTheLastSceneStays() throws Exception {
        change(scene -> scene.withMesh(MeshSource.of("cylinder")));
        awaitFinal();
        Files.delete(mesh);
        rest();
        await(() -> message().contains("square.obj"));
        assertThat(message()).doesNotContain("\n");
        assertThat(modelScene().mesh().name()).isEqualTo("cylinder");

        // A window smaller than the handle.
        onEvents(() -> {
            viewer.window.setBounds(0, 0, 130, 120);
            viewer.window.validate();
        });
        middle(0);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        middle(5);
        middle(200);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.waitForIdle();
        onEvents(() -> painted(viewer.window.picture));
    }
}
