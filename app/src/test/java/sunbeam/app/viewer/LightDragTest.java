package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import jrtr.scene.Camera;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;

final class LightDragTest {
    // A handful of float32 operations on numbers of size 1.
    private static final float ROUNDING = 1e-5f;
    private static final Camera FRONT = new Camera(new Vector3f(0, 0, 5), new Vector3f(), new Vector3f(0, 1, 0));
    private static final Vector3f FROM_VIEWER = new Vector3f(0, 0, 1);

    @Test
    void theLightGoesWhereTheMouseGoes() {
        assertThat(LightDrag.moved(FRONT, FROM_VIEWER, 0.3, 0).distance(sine(0.3), 0, cosine(0.3)))
                .isCloseTo(0, within(ROUNDING));
        assertThat(LightDrag.moved(FRONT, FROM_VIEWER, 0, 0.3).distance(0, sine(0.3), cosine(0.3)))
                .isCloseTo(0, within(ROUNDING));
    }

    @Test
    void theDirectionKeepsLengthOneOverManyDrags() {
        Vector3f light = new Vector3f(0.6f, 0, 0.8f);
        for (int drag = 0; drag < 1000; drag++) {
            light = LightDrag.moved(FRONT, light, 0.01, 0.02);
        }
        assertThat(light.length()).isCloseTo(1, within(ROUNDING));
    }

    private static float sine(double angle) {
        return (float) Math.sin(angle);
    }

    private static float cosine(double angle) {
        return (float) Math.cos(angle);
    }
}
