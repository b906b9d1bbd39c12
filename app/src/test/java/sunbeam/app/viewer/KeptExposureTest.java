package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneLight;
import sunbeam.app.scene.texture.BodyTexture;

class KeptExposureTest {
    private static final double FOUND = 7;

    private final KeptExposure exposures = new KeptExposure();
    private final BodyTexture body = new BodyTexture(1, 1, new byte[4]);
    private final Scene automatic = ViewerInAWindow.scene().withExposure(OptionalDouble.empty());

    private static SceneData data(Scene scene, BodyTexture body) {
        return new SceneData(scene, null, null, null, null, Optional.empty(), body);
    }

    private double exposure(Scene scene, BodyTexture texture) {
        return exposures.of(data(scene, texture), () -> FOUND);
    }

    @Test
    void itStaysWhileTheLightMoves() {
        assertThat(exposure(automatic, body)).isEqualTo(FOUND);
        exposures.found(data(automatic, body), 3);
        Scene moved = automatic.withLight(new SceneLight(new Vector3f(1, 0, 1), 2));
        assertThat(exposure(moved, body)).isEqualTo(3);
    }

    @Test
    void anotherSkinHasAnotherExposure() {
        exposures.found(data(automatic, body), 3);
        assertThat(exposure(automatic.withBlend(automatic.blend().withDiffraction(1)), body))
                .isEqualTo(FOUND);
        assertThat(exposure(automatic, new BodyTexture(1, 1, new byte[4]))).isEqualTo(FOUND);
    }

    @Test
    void anExposureThatTheUserSetIsNotTakenForAnAutomaticOne() {
        Scene set = automatic.withExposure(OptionalDouble.of(20));
        assertThat(exposures.found(data(set, body), 20)).isEqualTo(20);
        assertThat(exposure(automatic, body)).isEqualTo(FOUND);
        exposures.found(data(automatic, body), 3);
        assertThat(exposure(set, body)).isEqualTo(20);
    }
}
