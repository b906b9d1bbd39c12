package sunbeam.precompute.table;

/**
 * Description of a cached table, for people only.
 *
 * @param patch name of the surface that it was made for; others with the same heights share it
 * @param what content in a few words
 */
public record TableLabel(String patch, String what) {
    /** Digits of a hash behind a surface's name. */
    private static final int DIGITS = 6;

    /**
     * Describes a surface's table.
     *
     * @param name of the surface, not unique
     * @param digest of its heights, whose first digits make the name unique
     */
    public static TableLabel of(String name, String digest, String what) {
        return new TableLabel(name + " " + digest.substring(0, Math.min(DIGITS, digest.length())), what);
    }

    public static final TableLabel NONE = new TableLabel("", "");
}
