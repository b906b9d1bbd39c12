package sunbeam.app.viewer.loop;

import static sunbeam.app.render.SceneDisplay.TABLE_SAMPLES;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.stream.IntStream;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.render.SceneDisplay;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Srgb;

/**
 * Automatic exposure estimated from display colors. Clipped highlights and the ground distort the value, but the ratio of two values within
 * a drag follows the exposure.
 */
final class ScreenExposure {
    // Longer side of the reduced picture, in pixels: half of the meter's, since each frame waits for the estimate.
    private static final int SIDE = SceneDisplay.METER_SIDE / 2;
    private static final double[] LINEAR =
            IntStream.range(0, 256).mapToDouble(Srgb::linear).toArray();
    private static final double RED = Srgb.xyz(1, 0, 0)[1];
    private static final double GREEN = Srgb.xyz(0, 1, 0)[1];
    private static final double BLUE = Srgb.xyz(0, 0, 1)[1];

    private ScreenExposure() {}

    /** Estimates the exposure from display colors, ignoring pixels of the background's color. */
    static double of(BufferedImage shown, DisplayTransform display, int background) {
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
}
