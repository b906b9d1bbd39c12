package sunbeam.app.viewer;

import java.util.function.DoubleSupplier;
import sunbeam.app.scene.Blend;
import sunbeam.app.setup.MethodFactory;

/**
 * The automatic exposure of previews. One found from a preview's few pixels depends on whether a glint of a thousand times
 * white hits one of them; so while only light, camera and model move, that of the last final picture stays.
 */
final class KeptExposure {
    private MethodFactory method;
    private Blend blend;
    private double exposure;

    /** @param fromPicture gives the scene's exposure, or that which the preview's picture asks for */
    @SuppressWarnings("ReferenceEquality") // the same object as long as nothing is loaded anew
    double ofPreview(ViewState state, DoubleSupplier fromPicture) {
        boolean known =
                method == state.fine().method() && state.fine().scene().blend().equals(blend);
        return known && state.fine().scene().exposure().isEmpty() ? exposure : fromPicture.getAsDouble();
    }

    void finalPicture(ViewState state, double value) {
        method = state.fine().method();
        blend = state.fine().scene().blend();
        exposure = value;
    }
}
