package jrtr;

/**
 * Shape of a float texture, which is clamped at its edges.
 *
 * @param width texels per row, at least 1
 * @param height rows, at least 1
 * @param layers layers, at least 1
 * @param array whether the sampler is a {@code sampler2DArray}; otherwise it is a {@code sampler2D}, and there is one layer
 * @param format number and size of a texel's channels
 * @param filter interpolation between texels; the static factories choose {@link Filter#NEAREST}
 */
public record FloatTextureSpec(int width, int height, int layers, boolean array, FloatFormat format, Filter filter) {

    public FloatTextureSpec {
        if (width < 1 || height < 1 || layers < 1) {
            throw new IllegalArgumentException(
                    "texture of " + width + " x " + height + " x " + layers + ": every side must be at least 1");
        }
        if (!array && layers != 1) {
            throw new IllegalArgumentException("a texture of " + layers + " layers must be an array");
        }
    }

    /** Returns the shape of a texture with one layer, for a {@code sampler2D}. */
    public static FloatTextureSpec flat(int width, int height, FloatFormat format) {
        return new FloatTextureSpec(width, height, 1, false, format, Filter.NEAREST);
    }

    /** Returns the shape of a texture with layers of one size, for a {@code sampler2DArray}. */
    public static FloatTextureSpec array(int width, int height, int layers, FloatFormat format) {
        return new FloatTextureSpec(width, height, layers, true, format, Filter.NEAREST);
    }

    public FloatTextureSpec with(Filter newFilter) {
        return new FloatTextureSpec(width, height, layers, array, format, newFilter);
    }

    public long floatsPerLayer() {
        return (long) width * height * format.channels();
    }

    /** Returns the number of floats in all layers; {@link Long#MAX_VALUE} if that overflows. */
    public long floats() {
        long high = Math.multiplyHigh(floatsPerLayer(), layers);
        long low = floatsPerLayer() * layers;
        return high == 0 && low >= 0 ? low : Long.MAX_VALUE;
    }
}
