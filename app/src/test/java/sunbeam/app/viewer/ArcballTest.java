package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import jrtr.scene.Camera;
import org.joml.Quaternionf;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;

final class ArcballTest {
    // A handful of float32 operations on numbers of size 1.
    private static final float ROUNDING = 1e-5f;
    private static final Camera FRONT = new Camera(new Vector3f(0, 0, 5), new Vector3f(), new Vector3f(0, 1, 0));
    private static final Camera ABOVE = new Camera(new Vector3f(0, -5, 5), new Vector3f(), new Vector3f(0, 0, 1));

    @Test
    void dragToTheRightMovesTheFrontOfTheModelToTheRight() {
        Vector3f front = new Vector3f(0, 0, 1);
        new Quaternionf(Arcball.turn(FRONT, 0, 0, 0.1, 0)).transform(front);
        assertThat(front.x).isPositive();
        assertThat(front.y).isCloseTo(0, within(ROUNDING));
    }

    @Test
    void turnsFollowTheCameraNotTheWorld() {
        // Seen from above and the front, the picture's vertical is (0, 1, 1) / sqrt(2).
        Quaternionf turn = Arcball.turn(ABOVE, 0, 0, 0.3, 0);
        Vector3f axis = new Vector3f(turn.x, turn.y, turn.z).normalize();
        assertThat(axis.distance(new Vector3f(0, 1, 1).normalize())).isCloseTo(0, within(ROUNDING));
    }
}
