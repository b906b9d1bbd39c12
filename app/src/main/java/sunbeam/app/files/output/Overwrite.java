package sunbeam.app.files.output;

/** Treatment of an existing file. */
public enum Overwrite {
    /** Writing fails. */
    REFUSE,
    /** The new file replaces it when complete. */
    REPLACE,
    /** The new one gets the first free name of {@code stem-2}, {@code stem-3} and so on. */
    NUMBER
}
