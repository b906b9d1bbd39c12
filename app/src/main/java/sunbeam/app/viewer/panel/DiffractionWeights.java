package sunbeam.app.viewer.panel;

import java.util.OptionalDouble;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;

/**
 * Weights of diffracted light by method. Methods of Kirchhoff's integral are relative to a mirror, so that a skin needs weights of 1e4 and
 * more; {@code gem} is not, and would be white with these.
 */
final class DiffractionWeights {
    private static final double UNRELATED = 0.5;

    private OptionalDouble ofOthers = OptionalDouble.empty();

    /** Returns the scene after a change of its method, with the last weight of a method of the same kind. */
    Scene follow(Scene before, Scene after) {
        boolean was = isUnrelated(before);
        boolean is = isUnrelated(after);
        if (is && !was) {
            ofOthers = OptionalDouble.of(before.get(SceneSettings.DIFFRACTION));
            return weighted(after, UNRELATED);
        }
        return was && !is && ofOthers.isPresent() ? weighted(after, ofOthers.getAsDouble()) : after;
    }

    private static boolean isUnrelated(Scene scene) {
        return !scene.method().method().isNormalizedToMirror();
    }

    private static Scene weighted(Scene scene, double weight) {
        return scene.with(SceneSettings.DIFFRACTION, weight);
    }
}
