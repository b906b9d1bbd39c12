package sunbeam.precompute.table;

/**
 * What a kept table is, for people: nothing depends on it.
 *
 * @param patch name of the surface that it was made for; others of the same heights share it
 * @param what it is, in a few words
 */
public record TableLabel(String patch, String what) {
    /** Of a hash, at the end of a surface's name. */
    private static final int DIGITS = 6;

    /**
     * Of a surface.
     *
     * @param name that people call it; two may have the same
     * @param digest of its heights, whose first digits tell them apart
     */
    public static TableLabel of(String name, String digest, String what) {
        return new TableLabel(name + " " + digest.substring(0, Math.min(DIGITS, digest.length())), what);
    }

    /** Of a table that nobody has named. */
    public static final TableLabel NONE = new TableLabel("", "");
}
