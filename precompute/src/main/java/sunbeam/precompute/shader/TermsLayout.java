package sunbeam.precompute.shader;

/**
 * Layout of a spectrum's terms in a texture. The texels of one sample are side by side in a row, so that a pixel's reads are adjacent.
 * Texels beyond the limits of a row and of Java's heap are in further layers.
 *
 * @param texels number of texels per sample
 * @param together number of texels of a sample that are side by side in one layer
 * @param array shape of the texture; its layers are those of all grids
 */
public record TermsLayout(int texels, int together, ArrayLayout array) {
    /** Floats per texel. */
    public static final int CHANNELS = 4;

    // Longest row in texels that OpenGL 3.3 drivers in use support, and largest layer that is computed in the heap at a
    // time.
    private static final int LONGEST_ROW = 16384;
    private static final long LARGEST_LAYER_BYTES = 1L << 28;

    /**
     * Returns the layout of a number of grids of one size.
     *
     * @param samples number of samples per row
     * @param rows rows of samples in a grid
     * @param texels number of texels per sample
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
