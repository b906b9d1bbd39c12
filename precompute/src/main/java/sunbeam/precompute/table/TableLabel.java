package sunbeam.precompute.table;

/**
 * Description of a cached table for lists of the cache; it identifies nothing.
 *
 * @param patch name of the surface whose request made the table; other surfaces with the same heights use it, too
 * @param what content of the table in a few words
 */
public record TableLabel(String patch, String what) {
    /** Number of hexadecimal digits of the digest after a surface's name: enough to tell surfaces of one name apart. */
    private static final int DIGITS = 6;

    /**
     * Describes a surface's table.
     *
     * @param name name of the surface, not unique
     * @param digest digest of the heights, in hexadecimal, whose first digits make the name unique
     */
    public static TableLabel of(String name, String digest, String what) {
        return new TableLabel(name + " " + digest.substring(0, Math.min(DIGITS, digest.length())), what);
    }

    public static final TableLabel NONE = new TableLabel("", "");
}
