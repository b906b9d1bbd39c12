package jrtr;

import java.nio.FloatBuffer;
import java.nio.ShortBuffer;

/**
 * A table of floats for shaders. Values are row-major, channels interleaved: texel (x, y) of a layer starts at {@code (y
 * * width + x) * channels} and is {@code texelFetch(s, ivec2(x, y), 0)}, so row 0 of the array is texel row 0. NaN,
 * infinities and signed zeros arrive unchanged, denormals as far as the driver keeps them.
 *
 * <p>Every layer must be uploaded once before the texture is drawn with.
 */
public interface FloatTexture extends Texture, Resource {

    /** The shape asked for. */
    FloatTextureSpec spec();

    /**
     * Uploads all layers, one after the other.
     *
     * @param texels width x height x layers x channels floats
     * @throws IllegalArgumentException if there are more or fewer
     */
    void upload(float[] texels);

    /**
     * Uploads one layer.
     *
     * @param layer from 0
     * @param texels width x height x channels floats, from the position to the limit; the position stays. Memory that is not
     *     Java's own is read as it is.
     * @throws IllegalArgumentException if there are more or fewer, or no such layer
     */
    void uploadLayer(int layer, FloatBuffer texels);

    /**
     * As {@link #uploadLayer(int, FloatBuffer)}, of a texture whose floats have 16 bits.
     *
     * @param texels bits of floats (IEEE 754's binary16)
     * @throws IllegalArgumentException if there are more or fewer, no such layer, or floats of 32 bits
     */
    void uploadLayer(int layer, ShortBuffer texels);
}
