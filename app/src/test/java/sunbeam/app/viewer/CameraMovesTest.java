package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import jrtr.scene.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Viewpoint;

final class CameraMovesTest {
    // Float32 coordinates of size 5.
    private static final float ROUNDING = 1e-5f;
    private static final Viewpoint FRONT =
            new Viewpoint(new Camera(new Vector3f(0, 0, 5), new Vector3f(), new Vector3f(0, 1, 0)), Math.toRadians(90));

    @Test
    void zoomingInHalvesTheDistance() {
        Camera camera = CameraMoves.zoomed(FRONT, 0.5).camera();
        assertThat(camera.centerOfProjection().distance(0, 0, 2.5f)).isCloseTo(0, within(ROUNDING));
        assertThat(camera.lookAtPoint().length()).isZero();
    }

    @Test
    void whatIsSeenFollowsAPan() {
        // At 90 degrees the picture is 10 high at the point that is looked at.
        Camera camera = CameraMoves.panned(FRONT, 0.1, 0.2, 800, 600).camera();
        assertThat(camera.lookAtPoint().distance(-1, -2, 0)).isCloseTo(0, within(ROUNDING));
        assertThat(camera.centerOfProjection().distance(-1, -2, 5)).isCloseTo(0, within(ROUNDING));
    }
}
