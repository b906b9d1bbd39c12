package jrtr;

/**
 * Shape of a float render target.
 *
 * @param width pixels per row, at least 1
 * @param height rows, at least 1
 * @param colors number of color images, at least 1; the fragment shader's {@code layout(location = i) out vec4} writes image i
 * @param depth whether there is a 32-bit float depth image
 */
public record FloatTargetSpec(int width, int height, int colors, boolean depth, Format format) {
    /** Pixel format of color images. */
    public enum Format {
        RGBA32F,
        /** Four values of 8 bits for the screen, clamped to [0, 1]. */
        RGBA8
    }

    public FloatTargetSpec {
        if (width < 1 || height < 1 || colors < 1) {
            throw new IllegalArgumentException(
                    "target of " + width + " x " + height + " with " + colors + " images: each must be at least 1");
        }
    }

    public FloatTargetSpec(int width, int height, int colors, boolean depth) {
        this(width, height, colors, depth, Format.RGBA32F);
    }

    /** Returns the shape of a target with one color image of floats and no depth. */
    public static FloatTargetSpec color(int width, int height) {
        return new FloatTargetSpec(width, height, 1, false);
    }
}
