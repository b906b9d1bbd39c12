package sunbeam.precompute.shader;

import sunbeam.precompute.text.Text;

/**
 * Shape of an array of float32 as a texture holds it: rows of texels, channels interleaved, one layer after the other.
 *
 * @param sampler the sampler by which the shader reads it
 * @param width texels along a row, at least 1
 * @param height rows, at least 1
 * @param layers at least 1; 1 for a flat array
 * @param kind whether the shader names a layer
 * @param channels floats per texel: 1, 2 or 4
 * @param reading what lies between texels
 */
public record ArrayLayout(String sampler, int width, int height, int layers, Kind kind, int channels, Reading reading) {

    /** Whether the shader names a layer. */
    public enum Kind {
        /** One layer, {@code sampler2D}. */
        FLAT,
        /** Layers of one size, {@code sampler2DArray}. */
        LAYERED
    }

    /** What lies between texels. */
    public enum Reading {
        /** Nothing: single texels are fetched. */
        TEXELS,
        /** The linear interpolation of neighbors. */
        LINEAR
    }

    /** Rejects shapes that no texture has. */
    public ArrayLayout {
        if (width < 1 || height < 1 || layers < 1 || (kind == Kind.FLAT && layers != 1)) {
            throw new IllegalArgumentException(
                    Text.format("array '%s' of %d x %d x %d, %s", sampler, width, height, layers, kind));
        }
        if (channels != 1 && channels != 2 && channels != 4) {
            throw new IllegalArgumentException(Text.format("array '%s' with %d channels", sampler, channels));
        }
    }

    /** One layer of single texels. */
    public static ArrayLayout flat(String sampler, int width, int height, int channels) {
        return new ArrayLayout(sampler, width, height, 1, Kind.FLAT, channels, Reading.TEXELS);
    }

    /** Several layers of single texels. */
    public static ArrayLayout layered(String sampler, int width, int height, int layers, int channels) {
        return new ArrayLayout(sampler, width, height, layers, Kind.LAYERED, channels, Reading.TEXELS);
    }

    /** The same, interpolated between texels. */
    public ArrayLayout linear() {
        return new ArrayLayout(sampler, width, height, layers, kind, channels, Reading.LINEAR);
    }

    /** Floats of one layer. */
    public int floatsPerLayer() {
        return Math.multiplyExact(Math.multiplyExact(width, height), channels);
    }

    /** Bytes of all layers. */
    public long bytes() {
        return (long) Float.BYTES * channels * width * height * layers;
    }

    /** Texels along the longest side of a layer. */
    public int longestSide() {
        return Math.max(width, height);
    }
}
