package sunbeam.precompute.plan;

import java.util.Set;
import sunbeam.precompute.text.Text;

/**
 * Shape of a float32 array in a texture: rows of texels, channels interleaved, layer after layer.
 *
 * @param sampler name of the shader's sampler
 * @param layered whether the shader reads an array of textures, else one texture
 * @param channels floats per texel: 1, 2 or 4
 * @param filtered whether the shader reads between texels, linearly; else it fetches single texels
 */
public record ArrayLayout(
        String sampler, int width, int height, int layers, boolean layered, int channels, boolean filtered) {
    public ArrayLayout {
        boolean texels = width >= 1 && height >= 1 && layers >= 1 && (layered || layers == 1);
        if (!texels || !Set.of(1, 2, 4).contains(channels)) {
            throw new IllegalArgumentException(Text.format(
                    "array '%s' of %d x %d x %d with %d channels: a flat array has 1 layer, a texel 1, 2 or 4 channels",
                    sampler, width, height, layers, channels));
        }
    }

    public static ArrayLayout flat(String sampler, int width, int height, int channels) {
        return new ArrayLayout(sampler, width, height, 1, false, channels, false);
    }

    public static ArrayLayout layered(String sampler, int width, int height, int layers, int channels) {
        return new ArrayLayout(sampler, width, height, layers, true, channels, false);
    }

    public ArrayLayout linear() {
        return new ArrayLayout(sampler, width, height, layers, layered, channels, true);
    }

    public int floatsPerLayer() {
        return Math.multiplyExact(Math.multiplyExact(width, height), channels);
    }

    public long bytes() {
        return (long) Float.BYTES * channels * width * height * layers;
    }
}
