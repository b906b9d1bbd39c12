package sunbeam.precompute.plan;

/** Description of a cached table for lists of the cache; no part of its key. Surfaces with the same heights share the table. */
public record TableLabel(String patch, String what) {
    private static final int DIGITS = 6;

    /** Describes a surface's table; the first digits of the digest make the name unique. */
    public static TableLabel of(String name, String digest, String what) {
        return new TableLabel(name + " " + digest.substring(0, Math.min(DIGITS, digest.length())), what);
    }
}
