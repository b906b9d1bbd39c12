package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.Srgb;

/**
 * Automatic exposure of a scene: that of its first picture until it is metered, then that of the last metering, while light, model, camera or
 * method change. Scenes that set their exposure do not change it.
 */
final class CachedExposure {
    // Distance of the pixels by which a displayed picture is metered.
    private static final int STRIDE = 4;

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
     * Returns the known exposure, else that of the first picture with or without colors; until that is stored, a white body that faces the
     * light is displayed as white.
     */
    double soFar(Scene scene, int metering, boolean hasColors) {
        double intensity = scene.hasEnvironment()
                ? scene.get(SceneSettings.ENVIRONMENT_INTENSITY)
                : scene.light().intensity();
        double ofWhite = intensity > 0 ? 1 / intensity : 1;
        return known(scene, metering).orElse(hasFirst(scene, metering, hasColors) ? firstExposure : ofWhite);
    }

    private boolean hasFirst(Scene scene, int metering, boolean hasColors) {
        return List.of(inputs(scene, metering), hasColors).equals(firstInputs);
    }

    /** Stores the automatic exposure of a first picture; returns false if none is needed any more. */
    boolean storeFirst(Scene scene, int metering, boolean hasColors, Supplier<LinearPicture> picture) {
        if (known(scene, metering).isPresent() || hasFirst(scene, metering, hasColors)) {
            return false;
        }
        firstExposure = LinearPicture.exposure(picture.get());
        firstInputs = List.of(inputs(scene, metering), hasColors);
        return true;
    }

    /** Returns the luminance of a picture that was displayed with an exposure; highlights stay compressed. */
    static LinearPicture luminance(BufferedImage image, Scene scene, double exposure) {
        int width = image.getWidth() / STRIDE;
        int height = image.getHeight() / STRIDE;
        int background = scene.get(SceneSettings.BACKGROUND).rgb();
        float[] xyz = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            int rgb = 0xffffff & image.getRGB(STRIDE * (i % width), STRIDE * Math.floorDiv(i, width));
            double[] light = Srgb.xyz(Srgb.linear(rgb >> 16), Srgb.linear(rgb >> 8 & 255), Srgb.linear(rgb & 255));
            xyz[3 * i + 1] = rgb == background ? 0 : (float) (light[1] / exposure);
        }
        return new LinearPicture(width, height, xyz);
    }

    private static List<Object> inputs(Scene scene, int metering) {
        return List.of(scene.exposureInputs(), metering);
    }
}
