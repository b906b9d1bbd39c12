package sunbeam.precompute.shader;

import sunbeam.precompute.text.Text;

/**
 * Shape of a float32 array in a texture: rows of texels, channels interleaved, layer after layer.
 *
 * @param sampler name of the shader's sampler
 * @param layers 1 for a flat array
 * @param channels floats per texel: 1, 2 or 4
 */
public record ArrayLayout(String sampler, int width, int height, int layers, Kind kind, int channels, Reading reading) {

    /** Type of the sampler. */
    public enum Kind {
        /** {@code sampler2D}, one layer. */
        FLAT,
        /** {@code sampler2DArray}. */
        LAYERED
    }

    /** Filter between texels. */
    public enum Reading {
        /** None: single texels are fetched. */
        TEXELS,
        LINEAR
    }

    public ArrayLayout {
        if (width < 1 || height < 1 || layers < 1 || (kind == Kind.FLAT && layers != 1)) {
            throw new IllegalArgumentException(Text.format(
                    "array '%s' of %d x %d x %d, %s: each side must be at least 1, and FLAT needs 1 layer",
                    sampler, width, height, layers, kind));
        }
        if (channels != 1 && channels != 2 && channels != 4) {
            throw new IllegalArgumentException(
                    Text.format("array '%s' with %d channels: must be 1, 2 or 4", sampler, channels));
        }
    }

    public static ArrayLayout flat(String sampler, int width, int height, int channels) {
        return new ArrayLayout(sampler, width, height, 1, Kind.FLAT, channels, Reading.TEXELS);
    }

    public static ArrayLayout layered(String sampler, int width, int height, int layers, int channels) {
        return new ArrayLayout(sampler, width, height, layers, Kind.LAYERED, channels, Reading.TEXELS);
    }

    public ArrayLayout linear() {
        return new ArrayLayout(sampler, width, height, layers, kind, channels, Reading.LINEAR);
    }

    public int floatsPerLayer() {
        return Math.multiplyExact(Math.multiplyExact(width, height), channels);
    }

    public long bytes() {
        return (long) Float.BYTES * channels * width * height * layers;
    }

    public int longestSide() {
        return Math.max(width, height);
    }
}
