package sunbeam.app.viewer.loop;

import static sunbeam.app.render.PartSum.METER_SIDE;
import static sunbeam.app.render.PartSum.TABLE_SAMPLES;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.render.SceneData;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.setting.Choices;

/**
 * Automatic exposure of the last metered picture. While light, camera or model move, it follows the displayed pictures, so that it does not
 * jump when the final picture is metered. Scenes that set their exposure do not change it.
 */
final class CachedExposure {
    // Longer side of the reduced picture, in pixels: half of the meter's, since each frame waits for the estimate.
    private static final int SIDE = METER_SIDE / 2;
    private static final double[] LINEAR =
            IntStream.range(0, 256).mapToDouble(Srgb::linear).toArray();
    private static final double RED = Srgb.xyz(1, 0, 0)[1];
    private static final double GREEN = Srgb.xyz(0, 1, 0)[1];
    private static final double BLUE = Srgb.xyz(0, 0, 1)[1];

    private SceneData last;
    private double exposure;
    // Metered exposure over the estimate from the same picture on screen; NaN if unknown.
    private double perEstimate;

    /** Returns the exposure that the scene sets, or else the cached one; empty if none is cached for this mesh, method and body. */
    OptionalDouble known(SceneData data) {
        OptionalDouble chosen = data.scene().get(SceneSettings.EXPOSURE);
        return chosen.isPresent() || !looksTheSame(data, last) ? chosen : OptionalDouble.of(exposure);
    }

    double store(SceneData data, double value) {
        if (isAutomatic(data)) {
            last = data;
            exposure = value;
            perEstimate = Double.NaN;
        }
        return value;
    }

    /** Relates the stored exposure to its picture on screen, drawn with the exposure {@code used}. */
    void storeOnScreen(SceneData data, BufferedImage image, double used) {
        if (isAutomatic(data)) {
            perEstimate = exposure / onScreen(image, used, data.scene());
        }
    }

    /** Scales the metered exposure by the change of the exposure on screen since metering. */
    void follow(SceneData data, BufferedImage image, double used) {
        if (perEstimate > 0 && isAutomatic(data) && looksTheSame(data, last)) {
            exposure = perEstimate * onScreen(image, used, data.scene());
        }
    }

    private static boolean isAutomatic(SceneData data) {
        return data.scene().get(SceneSettings.EXPOSURE).isEmpty();
    }

    private static double onScreen(BufferedImage image, double used, Scene scene) {
        return onScreen(
                image, scene.display(used), scene.get(SceneSettings.BACKGROUND).rgb());
    }

    /**
     * Estimates the automatic exposure from display colors, ignoring pixels of the background's color. Clipped highlights and the ground
     * distort the value, but the ratio of two values within a drag follows the exposure.
     */
    static double onScreen(BufferedImage shown, DisplayTransform display, int background) {
        int[] rgb = ((DataBufferInt) shown.getRaster().getDataBuffer()).getData();
        double step = Math.max(1, Math.max(shown.getWidth(), shown.getHeight()) / (double) SIDE);
        int width = (int) (shown.getWidth() / step);
        int height = (int) (shown.getHeight() / step);
        // Factors that undo the compression of highlights, by the 8-bit value of the largest channel.
        double[] factors = IntStream.range(0, 256)
                .mapToDouble(channel -> channel == 0 ? 1 : display.tone().before(LINEAR[channel]) / LINEAR[channel])
                .toArray();
        float[] xyz = new float[3 * width * height];
        for (int i = 0; i < width * height; i++) {
            double sum = 0;
            for (int sample = 0; sample < TABLE_SAMPLES * TABLE_SAMPLES; sample++) {
                int x = (int) (step * (i % width + (sample % TABLE_SAMPLES + 0.5) / TABLE_SAMPLES));
                int y = (int) (step
                        * (Math.floorDiv(i, width) + (Math.floorDiv(sample, TABLE_SAMPLES) + 0.5) / TABLE_SAMPLES));
                int pixel = rgb[y * shown.getWidth() + x] & 0xffffff;
                sum += pixel == background ? 0 : luminance(pixel, factors);
            }
            xyz[3 * i + 1] = (float) (sum / (TABLE_SAMPLES * TABLE_SAMPLES * display.exposure()));
        }
        return LinearPicture.exposure(new LinearPicture(width, height, xyz));
    }

    private static double luminance(int pixel, double[] factors) {
        int red = pixel >> 16;
        int green = pixel >> 8 & 0xff;
        int blue = pixel & 0xff;
        double light = RED * LINEAR[red] + GREEN * LINEAR[green] + BLUE * LINEAR[blue];
        return light * factors[Math.max(red, Math.max(green, blue))];
    }

    @SuppressWarnings("ReferenceEquality") // unchanged parts keep their objects
    private static boolean looksTheSame(SceneData data, SceneData last) {
        return last != null
                && data.method() == last.method()
                && data.shape().whole() == last.shape().whole()
                && data.shape().things().equals(last.shape().things())
                && weights(data).equals(weights(last));
    }

    private static List<Choices> weights(SceneData data) {
        return data.scene().perObject().stream().map(Scene::weights).toList();
    }
}
