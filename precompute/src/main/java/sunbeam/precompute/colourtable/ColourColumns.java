package sunbeam.precompute.colourtable;

/**
 * Places at which colours are asked for, and takes these: columns of one (u, v) each, in some slices of w. Different places may be put by
 * different threads at once.
 */
public interface ColourColumns {

    /** Columns, of which some may be empty. */
    int count();

    /**
     * Where a column stands.
     *
     * @param uv takes u and v
     */
    void locate(int column, float[] uv);

    /** |w| of the slices in which any column is asked for, ascending. */
    double[] depths();

    /**
     * Whether a column is asked for in a slice.
     *
     * @param slice index of its depth
     */
    boolean isAsked(int column, int slice);

    /** Takes square roots of X, Y and Z; their signs do not count. */
    void putRoots(int column, int slice, double x, double y, double z);
}
