package sunbeam.app.viewer.loop;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.SceneSettings;

/**
 * Automatic exposure of the last picture. While light, camera or model move, it follows the displayed pictures, so that it does not jump at
 * the end.
 */
final class CachedExposure {
    private SceneData last;
    private double exposure;
    // The metered exposure, and the exposure estimated from the displayed picture at the same time; 0 if unknown.
    private double metered;
    private double ofShown;

    /** Returns the scene's own exposure, or the cached one; empty before the first metering. */
    OptionalDouble known(SceneData data) {
        if (data.scene().get(SceneSettings.EXPOSURE).isPresent()) {
            return data.scene().get(SceneSettings.EXPOSURE);
        }
        return showTheSame(data, last) ? OptionalDouble.of(exposure) : OptionalDouble.empty();
    }

    /** Returns {@link #known}, or meters and caches the exposure. */
    double of(SceneData data, DoubleSupplier found) {
        OptionalDouble known = known(data);
        return known.isPresent() ? known.getAsDouble() : found(data, found.getAsDouble());
    }

    /** Caches the metered exposure of a scene without its own; returns it. */
    double found(SceneData data, double value) {
        if (data.scene().get(SceneSettings.EXPOSURE).isEmpty()) {
            last = data;
            exposure = value;
            metered = value;
            ofShown = 0;
        }
        return value;
    }

    /** Stores the {@link ShownExposure} of the picture that was metered last. */
    void shown(double found) {
        ofShown = found;
    }

    /** Scales the metered exposure by the change of the {@link ShownExposure} since then. */
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
