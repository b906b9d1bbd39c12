package sunbeam.precompute.colortable;

/**
 * Places at which colors are asked for, and takes these: columns of one (u, v) each, in some slices of w. Different places may be put by
 * different threads at once.
 */
public interface ColorColumns {

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
     * In which slices a column is asked for.
     *
     * @param slices takes indices of their depths, ascending; as many as there are depths at most
     * @return how many
     */
    int asked(int column, int[] slices);

    /** Takes X, Y and Z: a sum of an expansion's terms may leave a dark direction a little below nothing. */
    default void put(int column, int slice, double x, double y, double z) {
        putRoots(column, slice, Math.sqrt(Math.max(0, x)), Math.sqrt(Math.max(0, y)), Math.sqrt(Math.max(0, z)));
    }

    /** Takes square roots of X, Y and Z; their signs do not count. */
    void putRoots(int column, int slice, double x, double y, double z);
}
