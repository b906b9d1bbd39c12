package sunbeam.app.viewer;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import sunbeam.app.scene.SceneData;

/**
 * The automatic exposure of previews. One found from a preview's few pixels depends on whether a glint of a thousand times
 * white hits one of them; so while only light, camera and model move, that of the last final picture stays.
 */
final class KeptExposure {
    private SceneData last;
    private double exposure;
    private SceneData lastPreview;
    private double ofLastPreview;

    /** @param fromPicture gives the scene's exposure, or that which the preview's picture asks for */
    double ofPreview(SceneData data, DoubleSupplier fromPicture) {
        OptionalDouble kept = ofFinal(data);
        if (kept.isPresent()) {
            return kept.getAsDouble();
        }
        lastPreview = data;
        ofLastPreview = fromPicture.getAsDouble();
        return ofLastPreview;
    }

    /** The scene's exposure, or that of its last final picture, or else of its last preview; none before. */
    OptionalDouble known(SceneData data) {
        if (data.scene().exposure().isPresent()) {
            return data.scene().exposure();
        }
        OptionalDouble kept = ofFinal(data);
        return kept.isEmpty() && showTheSame(data, lastPreview) ? OptionalDouble.of(ofLastPreview) : kept;
    }

    private OptionalDouble ofFinal(SceneData data) {
        boolean automatic = data.scene().exposure().isEmpty();
        return automatic && showTheSame(data, last) ? OptionalDouble.of(exposure) : OptionalDouble.empty();
    }

    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing is loaded anew
    private static boolean showTheSame(SceneData data, SceneData last) {
        return last != null
                && data.method() == last.method()
                && data.mesh() == last.mesh()
                && data.body() == last.body()
                && data.scene().blend().equals(last.scene().blend());
    }

    /** Of a final picture, by whatever the scene says. */
    void finalPicture(SceneData data, double value) {
        if (data.scene().exposure().isEmpty()) {
            last = data;
            exposure = value;
        }
    }
}
