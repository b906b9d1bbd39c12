package sunbeam.app.viewer;

import java.util.function.DoubleSupplier;
import sunbeam.app.scene.SceneData;

/**
 * The automatic exposure of previews. One found from a preview's few pixels depends on whether a glint of a thousand times
 * white hits one of them; so while only light, camera and model move, that of the last final picture stays.
 */
final class KeptExposure {
    private SceneData last;
    private double exposure;

    /** @param fromPicture gives the scene's exposure, or that which the preview's picture asks for */
    double ofPreview(SceneData data, DoubleSupplier fromPicture) {
        boolean automatic = data.scene().exposure().isEmpty();
        return automatic && last != null && showsTheSame(data) ? exposure : fromPicture.getAsDouble();
    }

    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing is loaded anew
    private boolean showsTheSame(SceneData data) {
        return data.method() == last.method()
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
