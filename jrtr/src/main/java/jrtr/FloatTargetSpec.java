package jrtr;

/**
 * Shape of a float render target.
 *
 * @param width pixels per row, at least 1
 * @param height rows, at least 1
 * @param colors RGBA32F images, at least 1; the fragment shader's {@code layout(location = i) out vec4} writes image i
 * @param depth whether there is a 32-bit float depth image
 */
public record FloatTargetSpec(int width, int height, int colors, boolean depth) {

    /** Rejects sizes below 1. */
    public FloatTargetSpec {
        if (width < 1 || height < 1 || colors < 1) {
            throw new IllegalArgumentException(
                    "target of " + width + " x " + height + " with " + colors + " images: each must be at least 1");
        }
    }

    /** One image, no depth. */
    public static FloatTargetSpec color(int width, int height) {
        return new FloatTargetSpec(width, height, 1, false);
    }
}
