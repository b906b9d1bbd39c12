package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.joml.Vector3f;
import org.junit.jupiter.api.Test;

class CameraTest {
    @Test
    void camerasWithoutAPictureAreRefused() {
        Vector3f eye = new Vector3f(1, 1, 1);
        Vector3f up = new Vector3f(0, 0, 1);

        assertThatThrownBy(() -> new Camera(eye, eye, up)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Camera(eye, new Vector3f(1, 1, 0), up)).hasMessageContaining("line of sight");
        assertThatThrownBy(() -> new Camera(eye, new Vector3f(), new Vector3f()))
                .hasMessageContaining("up");
        assertThatThrownBy(() -> new Camera(eye, new Vector3f(Float.NaN, 0, 0), up))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
