package sunbeam.precompute.shader;

/**
 * Description of a cached table, shown when the cache is listed; it is not part of the cache key.
 *
 * @param patch name of the surface for which the table was built, with digits of its digest; surfaces with the same heights share the table
 */
public record TableLabel(String patch, String what) {
    /** Number of hexadecimal digits of the digest; they distinguish surfaces of the same name. */
    private static final int DIGITS = 6;

    /** Describes a surface's table; the first digits of the digest make the name unique. */
    public static TableLabel of(String name, String digest, String what) {
        return new TableLabel(name + " " + digest.substring(0, Math.min(DIGITS, digest.length())), what);
    }

    public static final TableLabel NONE = new TableLabel("", "");
}
