package sunbeam.precompute.table;

/**
 * What a kept table is, for people: nothing depends on it.
 *
 * @param patch name of the surface that it was made for; others of the same heights share it
 * @param what it is, in a few words
 */
public record TableLabel(String patch, String what) {
    /** Of a table that nobody has named. */
    public static final TableLabel NONE = new TableLabel("", "");
}
