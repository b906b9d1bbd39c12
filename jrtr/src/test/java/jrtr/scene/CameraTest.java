package jrtr.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector4f;
import org.junit.jupiter.api.Test;

class CameraTest {
    // Float32 products of numbers of order 10.
    private static final float ROUNDING = 1e-5f;

    @Test
    void theMatrixIsTheOneFromRightUpAndBackward() {
        Vector3f eye = new Vector3f(4, -3, 2.5f);
        Vector3f point = new Vector3f(-1, 0.5f, 0.25f);
        Vector3f up = new Vector3f(0.1f, 0.2f, 1);

        Vector3f backward = new Vector3f(eye).sub(point).normalize();
        Vector3f right = new Vector3f(up).cross(backward).normalize();
        Vector3f upright = new Vector3f(backward).cross(right);
        Matrix4f byHand = new Matrix4f(
                right.x,
                upright.x,
                backward.x,
                0,
                right.y,
                upright.y,
                backward.y,
                0,
                right.z,
                upright.z,
                backward.z,
                0,
                -right.dot(eye),
                -upright.dot(eye),
                -backward.dot(eye),
                1);
        Matrix4f matrix = new Camera(eye, point, up).worldToCamera();

        assertThat(matrix.equals(byHand, ROUNDING)).isTrue();
        assertThat(matrix.equals(new Matrix4f().lookAt(eye, point, up), 0)).isTrue();
        Vector4f image = matrix.transform(new Vector4f(point, 1));
        assertThat(image.x).isBetween(-ROUNDING, ROUNDING);
        assertThat(image.y).isBetween(-ROUNDING, ROUNDING);
        assertThat(image.z).isEqualTo(-eye.distance(point), within(ROUNDING));
    }

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
