package sunbeam.app.viewer.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.setting.Choices;

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
}
