package sunbeam.app.viewer.loop;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;

/**
 * Automatic exposure of a scene: that of its first picture until it is metered, then that of the last metering, while light, model, camera or
 * method change. Scenes that set their exposure do not change it.
 */
final class CachedExposure {
    // Inputs of the last metering; empty before it.
    private List<Object> inputs = List.of();
    private double exposure;
    private List<Object> firstInputs = List.of();
    private double firstExposure;

    /** Returns the exposure that the scene sets, or else the cached one; empty if none is cached for this material and metering. */
    OptionalDouble known(Scene scene, int metering) {
        OptionalDouble chosen = scene.get(SceneSettings.EXPOSURE);
        return chosen.isPresent() || !inputs(scene, metering).equals(inputs) ? chosen : OptionalDouble.of(exposure);
    }

    void store(Scene scene, int metering, double value) {
        inputs = inputs(scene, metering);
        exposure = value;
    }

    /**
     * Returns the known exposure, else that of the first picture with colors; until that is stored, a white body that faces the light is
     * displayed as white, as in built-in scenes after metering: a picture without colors yet is about as bright as that with them.
     */
    double soFar(Scene scene, int metering) {
        double intensity = scene.hasEnvironment()
                ? scene.get(SceneSettings.ENVIRONMENT_INTENSITY)
                : scene.light().intensity();
        double ofWhite = intensity > 0 ? 1 / intensity : 1;
        return known(scene, metering).orElse(hasFirst(scene, metering) ? firstExposure : ofWhite);
    }

    private boolean hasFirst(Scene scene, int metering) {
        return inputs(scene, metering).equals(firstInputs);
    }

    /** Stores the automatic exposure of a first picture with colors, unless one is stored. */
    void storeFirst(Scene scene, int metering, Supplier<LinearPicture> picture) {
        if (known(scene, metering).isEmpty() && !hasFirst(scene, metering)) {
            firstExposure = LinearPicture.exposure(picture.get());
            firstInputs = inputs(scene, metering);
        }
    }

    private static List<Object> inputs(Scene scene, int metering) {
        return List.of(scene.exposureInputs(), metering);
    }
}
