package sunbeam.app.viewer.loop;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneSettings;

/**
 * The automatic exposure of the last picture. While light, camera and model move, it follows what is shown, so that it does not jump when
 * they stand still.
 */
final class CachedExposure {
    private SceneData last;
    private double exposure;
    // As found, and what was found at the same time from what is shown of it; 0 where that is not known.
    private double metered;
    private double ofShown;

    /** The scene's own exposure, or the one that was found for it; none before. */
    OptionalDouble known(SceneData data) {
        if (data.scene().get(SceneSettings.EXPOSURE).isPresent()) {
            return data.scene().get(SceneSettings.EXPOSURE);
        }
        return showTheSame(data, last) ? OptionalDouble.of(exposure) : OptionalDouble.empty();
    }

    /** As {@link #known}, found now where it is not known. */
    double of(SceneData data, DoubleSupplier found) {
        OptionalDouble known = known(data);
        return known.isPresent() ? known.getAsDouble() : found(data, found.getAsDouble());
    }

    /** Caches what was found for a scene that leaves it open; returns it. */
    double found(SceneData data, double value) {
        if (data.scene().get(SceneSettings.EXPOSURE).isEmpty()) {
            last = data;
            exposure = value;
            metered = value;
            ofShown = 0;
        }
        return value;
    }

    /** Notes what {@link ShownExposure} finds from the picture that was metered last. */
    void shown(double found) {
        ofShown = found;
    }

    /** Goes on from there as much as what is shown does. */
    void follow(SceneData data, DoubleSupplier found) {
        if (ofShown > 0 && data.scene().get(SceneSettings.EXPOSURE).isEmpty() && showTheSame(data, last)) {
            exposure = metered * found.getAsDouble() / ofShown;
        }
    }

    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing is loaded anew
    private static boolean showTheSame(SceneData data, SceneData last) {
        return last != null
                && data.method() == last.method()
                && data.mesh() == last.mesh()
                && data.body() == last.body()
                && data.scene().blend().equals(last.scene().blend());
    }
}
