package jrtr.gl;

import java.util.Arrays;
import jrtr.ColorEncoding;

/**
 * A picture or one of its mipmaps. Made here, not by the driver: software renderers take ten times as long, and each rounds in its own way.
 *
 * @param rgba 4 x width x height bytes, red first
 */
record MipLevel(int width, int height, byte[] rgba, ColorEncoding encoding) {
    private static final int CHANNELS = 4;
    // Of light from 0 to 1: the darkest byte of sRGB is five of them wide.
    private static final int STEPS = 1 << 14;
    private static final float[] PLAIN = new float[256];
    private static final float[] LIGHT = new float[256];
    private static final byte[] BYTES = new byte[STEPS + 1];

    static {
        for (int i = 0; i < PLAIN.length; i++) {
            double value = i / 255.0;
            PLAIN[i] = (float) value;
            LIGHT[i] = (float) (value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4));
        }
        for (int i = 0; i <= STEPS; i++) {
            double light = (double) i / STEPS;
            double value = light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
            BYTES[i] = (byte) Math.round(255 * value);
        }
    }

    boolean isLast() {
        return width == 1 && height == 1;
    }

    /** The next: half as wide and high, rounded down, at least 1; means over equal areas, in linear light. */
    MipLevel next() {
        MipLevel next = new MipLevel(
                Math.max(1, width / 2),
                Math.max(1, height / 2),
                new byte[CHANNELS * Math.max(1, width / 2) * Math.max(1, height / 2)],
                encoding);
        float[] sums = new float[CHANNELS];
        for (int row = 0; row < next.height; row++) {
            for (int column = 0; column < next.width; column++) {
                mean(column, row, next, sums);
                for (int c = 0; c < CHANNELS; c++) {
                    next.rgba[CHANNELS * (row * next.width + column) + c] = isLight(c)
                            ? BYTES[(int) (STEPS * Math.min(1, sums[c]) + 0.5f)]
                            : (byte) (255 * Math.min(1, sums[c]) + 0.5f);
                }
            }
        }
        return next;
    }

    private boolean isLight(int channel) {
        return encoding == ColorEncoding.SRGB && channel < CHANNELS - 1;
    }

    /** Over the texels, and parts of texels, that a texel of the next level covers. */
    private void mean(int column, int row, MipLevel next, float[] sums) {
        float across = (float) width / next.width;
        float down = (float) height / next.height;
        Arrays.fill(sums, 0);
        for (int y = (int) (row * down); y < Math.min(height, (row + 1) * down); y++) {
            float high = Math.min(y + 1, (row + 1) * down) - Math.max(y, row * down);
            for (int x = (int) (column * across); x < Math.min(width, (column + 1) * across); x++) {
                float wide = Math.min(x + 1, (column + 1) * across) - Math.max(x, column * across);
                float weight = wide * high / (across * down);
                int at = CHANNELS * (y * width + x);
                for (int c = 0; c < CHANNELS; c++) {
                    sums[c] += weight * (isLight(c) ? LIGHT : PLAIN)[rgba[at + c] & 0xFF];
                }
            }
        }
    }
}
