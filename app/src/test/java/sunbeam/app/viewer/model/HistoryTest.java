package sunbeam.app.viewer.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import jrtr.scene.View.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.scene.Viewpoint;
import sunbeam.precompute.setting.Choices;

/** Changes of a scene by the mouse, and their undoing. */
final class HistoryTest {
    private final ViewerModel.History history = new ViewerModel.History();
    private Scene now = scene(0);

    private static Scene scene(double angle) {
        return Scenes.load("light-left").with(Choices.none().with(SceneSettings.ROTATE_PATCH, angle));
    }

    private void change(double angle) {
        history.changed(now, scene(angle));
        now = scene(angle);
    }

    private void drag(double... angles) {
        history.setDragging(true);
        for (double angle : angles) {
            change(angle);
        }
        history.setDragging(false);
    }

    private double undo() {
        now = history.undo(now).orElse(now);
        return now.get(SceneSettings.ROTATE_PATCH);
    }

    private double redo() {
        now = history.redo(now).orElse(now);
        return now.get(SceneSettings.ROTATE_PATCH);
    }

    @Test
    void aDragIsOneStepAndIsDoneAgain() {
        drag(0.1, 0.2, 0.3);
        drag(0.4, 0.5);
        assertThat(undo()).isEqualTo(0.3);
        assertThat(undo()).isZero();
        assertThat(undo()).as("there is nothing before").isZero();
        assertThat(redo()).isEqualTo(0.3);
        assertThat(redo()).isEqualTo(0.5);
        assertThat(redo()).isEqualTo(0.5);
    }

    @Test
    void aSceneThatIsOpenedRightAfterAChangeIsAStepOfItsOwn() {
        change(0.1);
        history.opened(now, scene(0.2));
        now = scene(0.2);
        change(0.3);
        assertThat(undo()).isEqualTo(0.2);
        assertThat(undo()).isEqualTo(0.1);
        assertThat(undo()).isZero();
    }

    @Test
    void whatChangesAfterAnUndoTakesThePlaceOfWhatWasUndone() {
        drag(0.1);
        drag(0.2);
        undo();
        drag(0.7);
        assertThat(redo()).isEqualTo(0.7);
        assertThat(undo()).isEqualTo(0.1);
        assertThat(undo()).isZero();
    }

    @Test
    void whatCouldNotBeLoadedLeavesNothingToUndo() {
        drag(0.1);
        history.setDragging(true);
        history.changed(now, scene(0.2));
        history.setDragging(false);
        // The change is refused, so the scene is as before.
        assertThat(undo()).isZero();
    }

    // Rounding of a few float32 operations on numbers of size 5.
    private static final float ROUNDING = 1e-5f;
    private static final Camera FRONT = new Camera(new Vector3f(0, 0, 5), new Vector3f(), new Vector3f(0, 1, 0));
    private static final Scene SCENE = seenFrom(FRONT).withLight(new SceneLight(new Vector3f(0, 0, 1), 1, 0));

    private static Scene seenFrom(Camera camera) {
        return Scenes.load("disc")
                .withView(new Viewpoint(camera, Math.toRadians(90)))
                .withOrientation(new Quaternionf());
    }

    private static void assertNear(Vector3fc found, double x, double y, double z) {
        assertThat(found.distance((float) x, (float) y, (float) z)).isCloseTo(0, within(ROUNDING));
    }

    @Test
    void theFrontOfTheModelAndTheLightGoWhereTheMouseGoesAndARollIsCounterclockwise() {
        double sine = Math.sin(0.1);
        double cosine = Math.cos(0.1);
        assertNear(Drags.turned(SCENE, 0.1, 0).orientation().transform(new Vector3f(0, 0, 1)), sine, 0, cosine);
        assertNear(Drags.turned(SCENE, 0, 0.1).orientation().transform(new Vector3f(0, 0, 1)), 0, sine, cosine);
        assertNear(Drags.rolled(SCENE, 0.1).orientation().transform(new Vector3f(1, 0, 0)), cosine, sine, 0);
        assertNear(Drags.lit(SCENE, 0.1, 0).light().towards(), sine, 0, cosine);
        assertNear(Drags.lit(SCENE, 0, 0.1).light().towards(), 0, sine, cosine);
    }

    @Test
    void anUprightModelStaysUprightHoweverItIsTurned() {
        Scene scene = seenFrom(new Camera(new Vector3f(0, -5, 5), new Vector3f(), new Vector3f(0, 0, 1)));
        for (int drag = 0; drag < 100; drag++) {
            scene = Drags.turned(scene, 0.3, 0.2 * Math.sin(drag));
            Vector3f vertical = scene.orientation().transform(new Vector3f(0, 0, 1));
            // The picture's horizontal is x; rounding errors of float32 rotations add up over the drags.
            assertThat(vertical.x).isCloseTo(0, within(100 * ROUNDING));
        }
    }

    @Test
    void zoomingInHalvesTheDistance() {
        Camera camera = Drags.zoomed(SCENE, 0.5, 0, 0, 800, 600).view().camera();
        assertNear(camera.centerOfProjection(), 0, 0, 2.5);
        assertThat(camera.lookAtPoint().length()).isZero();
    }

    @Test
    void whatIsUnderThePointerStaysThereAtAnyDistance() {
        Viewpoint near = Drags.zoomed(SCENE, 0.5, 0.25, -0.1, 800, 600).view();
        for (float depth : new float[] {-3, 0, 2}) {
            Vector3f point = new Vector3f(0.5f, -0.2f, -1).mul(5 - depth).add(0, 0, 5);
            Vector3f seen = near.camera().worldToCamera().transformPosition(point);
            assertThat(seen.x / -seen.z).isCloseTo(0.5f, within(ROUNDING));
            assertThat(seen.y / -seen.z).isCloseTo(-0.2f, within(ROUNDING));
        }
    }

    @Test
    void whatIsSeenFollowsAPan() {
        // With a field of view of 90 degrees the picture is 10 high at the target.
        Camera camera = Drags.panned(SCENE, 0.1, 0.2, 800, 600).view().camera();
        assertNear(camera.lookAtPoint(), -1, -2, 0);
        assertNear(camera.centerOfProjection(), -1, -2, 5);
    }
}
