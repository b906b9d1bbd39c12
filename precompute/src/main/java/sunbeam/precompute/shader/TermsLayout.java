package sunbeam.precompute.shader;

/**
 * Layout of a spectrum's terms in a texture. The texels of one sample are side by side in a row, so that a pixel's reads are adjacent;
 * texels beyond the limits of a row and of Java's heap are in further layers.
 *
 * @param together number of texels of a sample in one layer
 */
public record TermsLayout(int texels, int together, ArrayLayout array) {
    public static final int CHANNELS = 4;

    // Limits of OpenGL 3.3 drivers in use, and of a layer that is computed in the heap at a time.
    private static final int LONGEST_ROW = 16384;
    private static final long LARGEST_LAYER_BYTES = 1L << 28;

    /** Returns the layout of some grids of one size. */
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
