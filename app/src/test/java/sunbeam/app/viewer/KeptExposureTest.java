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
    private static final double OF_PREVIEW = 7;

    private final KeptExposure exposures = new KeptExposure();
    private final BodyTexture body = new BodyTexture(1, 1, new byte[4]);
    private final Scene automatic = ViewerInAWindow.scene().withExposure(OptionalDouble.empty());

    private static SceneData data(Scene scene, BodyTexture body) {
        return new SceneData(scene, null, null, null, null, Optional.empty(), body);
    }

    private double ofPreview(Scene scene, BodyTexture texture) {
        return exposures.ofPreview(data(scene, texture), () -> OF_PREVIEW);
    }

    @Test
    void theFinalPicturesStaysWhileTheLightMoves() {
        assertThat(ofPreview(automatic, body)).isEqualTo(OF_PREVIEW);
        exposures.finalPicture(data(automatic, body), 3);
        Scene moved = automatic.withLight(new SceneLight(new Vector3f(1, 0, 1), 2));
        assertThat(ofPreview(moved, body)).isEqualTo(3);
    }

    @Test
    void anotherSkinHasAnotherExposure() {
        exposures.finalPicture(data(automatic, body), 3);
        assertThat(ofPreview(automatic.withBlend(automatic.blend().withDiffraction(1)), body))
                .isEqualTo(OF_PREVIEW);
        assertThat(ofPreview(automatic, new BodyTexture(1, 1, new byte[4]))).isEqualTo(OF_PREVIEW);
    }

    @Test
    void anExposureThatTheUserSetIsNotTakenForAnAutomaticOne() {
        Scene set = automatic.withExposure(OptionalDouble.of(20));
        exposures.finalPicture(data(set, body), 20);
        assertThat(ofPreview(automatic, body)).isEqualTo(OF_PREVIEW);
        exposures.finalPicture(data(automatic, body), 3);
        assertThat(ofPreview(set, body)).isEqualTo(OF_PREVIEW);
    }
}
