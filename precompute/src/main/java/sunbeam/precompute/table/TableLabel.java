package sunbeam.precompute.table;

/**
 * Description of a cached table for lists of the cache; it identifies nothing.
 *
 * @param patch name of the surface whose request made the table; others with the same heights use it, too
 */
public record TableLabel(String patch, String what) {
    /** Hexadecimal digits of the digest that tell surfaces of one name apart. */
    private static final int DIGITS = 6;

    /** Describes a surface's table; the first digits of the digest make the name unique. */
    public static TableLabel of(String name, String digest, String what) {
        return new TableLabel(name + " " + digest.substring(0, Math.min(DIGITS, digest.length())), what);
    }

    public static final TableLabel NONE = new TableLabel("", "");
}
