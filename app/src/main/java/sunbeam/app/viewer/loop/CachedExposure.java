package sunbeam.app.viewer.loop;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.SceneSettings;

/**
 * Automatic exposure of the last metered picture. While light, camera or model move, it follows the displayed pictures, so that it does not
 * jump when the final picture is metered.
 */
final class CachedExposure {
    private SceneData last;
    private double exposure;
    // The metered exposure, and the {@link ScreenExposure} of the metered picture; 0 if unknown.
    private double metered;
    private double shownWhenMetered;

    /** Returns the exposure that the scene sets, or else the cached one; empty if none is cached for this mesh, method and body. */
    OptionalDouble known(SceneData data) {
        if (data.scene().get(SceneSettings.EXPOSURE).isPresent()) {
            return data.scene().get(SceneSettings.EXPOSURE);
        }
        return looksTheSame(data, last) ? OptionalDouble.of(exposure) : OptionalDouble.empty();
    }

    double of(SceneData data, DoubleSupplier meter) {
        OptionalDouble known = known(data);
        return known.isPresent() ? known.getAsDouble() : store(data, meter.getAsDouble());
    }

    /** Caches the metered exposure, unless the scene sets its exposure; returns the metered one. */
    double store(SceneData data, double value) {
        if (data.scene().get(SceneSettings.EXPOSURE).isEmpty()) {
            last = data;
            exposure = value;
            metered = value;
            shownWhenMetered = 0;
        }
        return value;
    }

    void storeOnScreen(double value) {
        shownWhenMetered = value;
    }

    /** Scales the metered exposure by the change of the {@link ScreenExposure} since metering. */
    void follow(SceneData data, DoubleSupplier shown) {
        if (shownWhenMetered > 0 && data.scene().get(SceneSettings.EXPOSURE).isEmpty() && looksTheSame(data, last)) {
            exposure = metered * shown.getAsDouble() / shownWhenMetered;
        }
    }

    @SuppressWarnings("ReferenceEquality") // unchanged parts keep their objects
    private static boolean looksTheSame(SceneData data, SceneData last) {
        return last != null
                && data.method() == last.method()
                && data.mesh() == last.mesh()
                && data.body() == last.body()
                && data.scene().weights().equals(last.scene().weights());
    }
}
