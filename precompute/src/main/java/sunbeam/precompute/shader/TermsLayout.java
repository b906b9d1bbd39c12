package sunbeam.precompute.shader;

/**
 * Layout of a spectrum's terms in a texture: the texels of one sample side by side in a row, so that a pixel's reads are adjacent; as many
 * as the limits of a texture's row and of Java's heap allow.
 *
 * @param texels per sample
 * @param together texels side by side; the others are in further layers
 * @param array shape of the texture; {@link ArrayLayout#layers} counts all grids
 */
public record TermsLayout(int texels, int together, ArrayLayout array) {
    /** Floats per texel. */
    public static final int CHANNELS = 4;

    // Longest row of OpenGL 3.3 drivers in use, and largest layer in the heap.
    private static final int LONGEST_ROW = 16384;
    private static final long LARGEST_LAYER_BYTES = 1L << 28;

    /**
     * Returns the layout of some grids of one size.
     *
     * @param samples per row
     * @param texels per sample
     */
    public static TermsLayout of(String sampler, int samples, int rows, int texels, int grids) {
        long bytes = (long) Float.BYTES * CHANNELS * samples * rows;
        long most = Math.min(LONGEST_ROW / samples, LARGEST_LAYER_BYTES / bytes);
        int together = (int) Math.max(1, Math.min(texels, most));
        int layers = (texels + together - 1) / together;
        return new TermsLayout(
                texels, together, ArrayLayout.layered(sampler, samples * together, rows, grids * layers, CHANNELS));
    }

    public int layersPerGrid() {
        return (texels + together - 1) / together;
    }

    public int samples() {
        return array.width() / together;
    }
}
