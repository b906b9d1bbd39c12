package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;

/**
 * 8-bit RGBA texture ({@code sampler2D}) that repeats, with trilinear filtering; mipmaps are averaged in linear light. Texture coordinate
 * (0, 0) is the picture's bottom left corner, (1, 1) the top right, as in mesh files.
 */
public final class ImageTexture extends Texture {
    public enum Encoding {
        /** sRGB (IEC 61966-2-1) in red, green and blue; the sampler gives linear light. Alpha is linear. */
        SRGB,
        /** Byte / 255, as for masks and normal maps. */
        LINEAR
    }

    ImageTexture(GlDevice device, String label, MipLevel image) {
        super(device, label, GL3.GL_TEXTURE_2D);
        orClose(() -> upload(gl(), image), this::close);
    }

    private ImageTexture upload(GL3 gl, MipLevel image) {
        requireSides(image.width, image.height, 1);
        begin(gl, GL3.GL_REPEAT, GL3.GL_LINEAR_MIPMAP_LINEAR, GL3.GL_LINEAR);
        int format = image.encoding == Encoding.SRGB ? GL3.GL_SRGB8_ALPHA8 : GL3.GL_RGBA8;
        MipLevel level = image.flipped();
        for (int number = 0; level != null; number++) {
            ByteBuffer texels = ByteBuffer.wrap(level.rgba);
            int type = GL3.GL_UNSIGNED_BYTE;
            gl.glTexImage2D(glTarget, number, format, level.width, level.height, 0, GL3.GL_RGBA, type, texels);
            level = level.width == 1 && level.height == 1 ? null : level.next();
        }
        device().check(gl, "uploading '" + label() + "'");
        return this;
    }

    /**
     * Mip level of an image: 4 x width x height bytes, red first. The CPU computes mipmaps, since drivers round means down, level by level:
     * a scene by the thesis's preset then differs by 2.3 of CIE 1976 in the mean.
     */
    record MipLevel(int width, int height, byte[] rgba, Encoding encoding) {
        private static final int CHANNELS = 4;
        /** Steps of [0, 1] in the table from linear light to sRGB bytes; the darkest bytes, the closest together, are five steps apart. */
        private static final int STEPS = 1 << 14;

        // From byte to value without and with sRGB decoding, and from linear light (in STEPS steps) to sRGB byte.
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

        MipLevel flipped() {
            byte[] flipped = new byte[rgba.length];
            int rowBytes = CHANNELS * width;
            for (int row = 0; row < height; row++) {
                System.arraycopy(rgba, row * rowBytes, flipped, (height - 1 - row) * rowBytes, rowBytes);
            }
            return new MipLevel(width, height, flipped, encoding);
        }

        /** Half as wide and high, rounded down, at least 1. Each texel is the area mean, in linear light, of the texels that it covers. */
        MipLevel next() {
            float[][] across = overlaps(width);
            float[][] down = overlaps(height);
            byte[] means = new byte[CHANNELS * across.length * down.length];
            for (int channel = 0; channel < CHANNELS; channel++) {
                boolean isLight = encoding == Encoding.SRGB && channel < CHANNELS - 1;
                float[] values = isLight ? SRGB_TO_LINEAR : BYTE_TO_VALUE;
                int at = channel;
                for (int row = 0; row < down.length; row++) {
                    for (int column = 0; column < across.length; column++) {
                        int corner = CHANNELS * (2 * row * width + 2 * column) + channel;
                        float mean = Math.min(1, mean(values, corner, across[column], down[row]));
                        means[at] = isLight ? LINEAR_TO_SRGB[(int) (STEPS * mean + 0.5f)] : (byte) (255 * mean + 0.5f);
                        at += CHANNELS;
                    }
                }
            }
            return new MipLevel(across.length, down.length, means, encoding);
        }

        private float mean(float[] values, int corner, float[] across, float[] down) {
            float sum = 0;
            for (int y = 0; y < down.length; y++) {
                float inRow = 0;
                for (int x = 0; x < across.length; x++) {
                    inRow += across[x] * values[rgba[corner + CHANNELS * (y * width + x)] & 0xFF];
                }
                sum += down[y] * inRow;
            }
            return sum;
        }

        /** Returns the shares of each texel i of the next level that 2 texels from 2 i on cover; 3 of an odd side, 1 of a side of 1. */
        private static float[][] overlaps(int side) {
            int length = Math.max(1, side / 2);
            float[][] shares = new float[length][Math.min(side, 2 + side % 2)];
            for (int i = 0; i < length; i++) {
                for (int k = 0; k < shares[i].length; k++) {
                    // In units of the axis / (length side).
                    double covered = Math.min((2 * i + k + 1.0) * length, (i + 1.0) * side)
                            - Math.max((2 * i + k) * (double) length, (double) i * side);
                    shares[i][k] = (float) (covered / side);
                }
            }
            return shares;
        }
    }
}
