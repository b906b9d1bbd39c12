package jrtr.gl;

import jrtr.ColorEncoding;

/**
 * Mip level of an image. The CPU computes mipmaps, since software drivers take ten times as long and drivers round differently.
 *
 * @param rgba 4 x width x height bytes, red first
 */
record MipLevel(int width, int height, byte[] rgba, ColorEncoding encoding) {
    private static final int CHANNELS = 4;
    /**
     * Steps of [0, 1] in the table from linear light to sRGB bytes. The darkest bytes, which are closest together in linear light, are five
     * steps apart.
     */
    private static final int STEPS = 1 << 14;

    // Tables from byte to value without and with sRGB decoding, and from linear light (in STEPS steps) to sRGB byte.
    private static final float[] BYTE_TO_VALUE = new float[256];
    private static final float[] SRGB_TO_LINEAR = new float[256];
    private static final byte[] LINEAR_TO_SRGB = new byte[STEPS + 1];

    static {
        for (int i = 0; i < BYTE_TO_VALUE.length; i++) {
            double value = i / 255.0;
            BYTE_TO_VALUE[i] = (float) value;
            SRGB_TO_LINEAR[i] = (float) (value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4));
        }
        for (int i = 0; i <= STEPS; i++) {
            double light = (double) i / STEPS;
            double value = light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
            LINEAR_TO_SRGB[i] = (byte) Math.round(255 * value);
        }
    }

    boolean isLast() {
        return width == 1 && height == 1;
    }

    /**
     * Returns the next level: half as wide and high, rounded down, at least 1. Each texel is the area mean, in linear light, of the texels
     * that it covers.
     */
    MipLevel next() {
        Halving across = Halving.of(width);
        Halving down = Halving.of(height);
        byte[] means = new byte[CHANNELS * across.length() * down.length()];
        for (int channel = 0; channel < CHANNELS; channel++) {
            boolean isLight = encoding == ColorEncoding.SRGB && channel < CHANNELS - 1;
            float[] values = isLight ? SRGB_TO_LINEAR : BYTE_TO_VALUE;
            int at = channel;
            for (int row = 0; row < down.length(); row++) {
                for (int column = 0; column < across.length(); column++) {
                    float mean = Math.min(1, mean(values, channel, across, column, down, row));
                    means[at] = isLight ? LINEAR_TO_SRGB[(int) (STEPS * mean + 0.5f)] : (byte) (255 * mean + 0.5f);
                    at += CHANNELS;
                }
            }
        }
        return new MipLevel(across.length(), down.length(), means, encoding);
    }

    private float mean(float[] values, int channel, Halving across, int column, Halving down, int row) {
        float sum = 0;
        for (int y = 0; y < down.texels(); y++) {
            int line = (down.first(row) + y) * width + across.first(column);
            float inRow = 0;
            for (int x = 0; x < across.texels(); x++) {
                inRow += across.weight(column, x) * values[rgba[CHANNELS * (line + x) + channel] & 0xFF];
            }
            sum += down.weight(row, y) * inRow;
        }
        return sum;
    }

    /**
     * Texels and weights along one axis for the next level.
     *
     * @param texels number of texels averaged into one texel of the next level: 2, or 3 if the side is odd, or 1 if the side is 1
     */
    private record Halving(int length, int texels, float[] weights) {
        static Halving of(int side) {
            int length = Math.max(1, side / 2);
            int texels = Math.min(side, 2 + side % 2);
            float[] weights = new float[length * texels];
            for (int i = 0; i < length; i++) {
                for (int k = 0; k < texels; k++) {
                    // Overlap of texel 2 i + k with texel i of the next level, in units of 1 / (length * side) of the
                    // axis.
                    double covered = Math.min((2 * i + k + 1.0) * length, (i + 1.0) * side)
                            - Math.max((2 * i + k) * (double) length, (double) i * side);
                    weights[i * texels + k] = (float) (covered / side);
                }
            }
            return new Halving(length, texels, weights);
        }

        int first(int index) {
            return 2 * index;
        }

        float weight(int index, int texel) {
            return weights[index * texels + texel];
        }
    }
}
