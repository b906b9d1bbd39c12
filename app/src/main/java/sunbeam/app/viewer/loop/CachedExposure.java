package sunbeam.app.viewer.loop;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import sunbeam.app.scene.SceneData;

/** The automatic exposure of the last picture, which the next one is shown with while light, camera and model move. */
final class CachedExposure {
    private SceneData last;
    private double exposure;

    /** The scene's own exposure, or the one that was found for it; none before. */
    OptionalDouble known(SceneData data) {
        if (data.scene().exposure().isPresent()) {
            return data.scene().exposure();
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
        if (data.scene().exposure().isEmpty()) {
            last = data;
            exposure = value;
        }
        return value;
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
