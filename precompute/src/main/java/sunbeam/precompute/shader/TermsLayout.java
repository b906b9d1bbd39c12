package sunbeam.precompute.shader;

/**
 * How terms of a spectrum, some a texel, lie in a texture: texels of one place side by side in a row, so that what a pixel
 * reads there lies together in memory and at constant distances; as many as a texture's row and Java's heap bear.
 *
 * @param texels of one place
 * @param together of these side by side; the rest lies in further layers
 * @param array the texture's shape, of which {@link ArrayLayout#layers} hold the texels once or, for several grids, each as
 *     often
 */
public record TermsLayout(int texels, int together, ArrayLayout array) {
    /** Floats of a texel. */
    public static final int CHANNELS = 4;

    // The longest row that drivers of OpenGL 3.3 in use have in common, and what one layer may take while it is made.
    private static final int LONGEST_ROW = 16384;
    private static final long LARGEST_LAYER_BYTES = 1L << 28;

    /**
     * The layout of some grids of one size.
     *
     * @param samples places along a row
     * @param rows of places
     * @param texels of one place
     * @param grids one after the other
     */
    public static TermsLayout of(String sampler, int samples, int rows, int texels, int grids) {
        long bytes = (long) Float.BYTES * CHANNELS * samples * rows;
        long most = Math.min(LONGEST_ROW / samples, LARGEST_LAYER_BYTES / bytes);
        int together = (int) Math.max(1, Math.min(texels, most));
        int layers = (texels + together - 1) / together;
        return new TermsLayout(
                texels, together, ArrayLayout.layered(sampler, samples * together, rows, grids * layers, CHANNELS));
    }

    /** Layers of one grid. */
    public int layersPerGrid() {
        return (texels + together - 1) / together;
    }

    /** Places along a row. */
    public int samples() {
        return array.width() / together;
    }
}
