package sunbeam.app.viewer.panel;

import java.util.OptionalDouble;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;

/**
 * Remembers the weight of diffracted light when the method changes. Most methods give power relative to a mirror's peak, so that a skin
 * needs weights of 1e4 and more; {@code gem} does not and would be white with such a weight.
 */
final class DiffractionWeights {
    private static final double WEIGHT_WITHOUT_MIRROR = 0.5;

    private OptionalDouble relativeToMirror = OptionalDouble.empty();

    /**
     * Returns the scene {@code after} a change of its method with the weight that suits the new method: between methods of both kinds, the
     * last weight relative to a mirror is stored and restored.
     */
    Scene follow(Scene before, Scene after) {
        boolean was = lacksMirrorScale(before);
        boolean is = lacksMirrorScale(after);
        if (is && !was) {
            relativeToMirror = OptionalDouble.of(before.get(SceneSettings.DIFFRACTION));
            return weighted(after, WEIGHT_WITHOUT_MIRROR);
        }
        return was && !is && relativeToMirror.isPresent() ? weighted(after, relativeToMirror.getAsDouble()) : after;
    }

    private static boolean lacksMirrorScale(Scene scene) {
        return !scene.method().method().isNormalizedToMirror();
    }

    private static Scene weighted(Scene scene, double weight) {
        return scene.with(SceneSettings.DIFFRACTION, weight);
    }
}
