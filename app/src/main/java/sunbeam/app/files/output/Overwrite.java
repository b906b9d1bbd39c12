package sunbeam.app.files.output;

/** Treatment of a file that exists where an output is to be written. */
public enum Overwrite {
    /** The existing file stays, and writing fails. */
    REFUSE,
    /** The existing file is replaced when the new one is complete. */
    REPLACE,
    /** The existing file stays, and the new one gets the first free name of {@code stem-2}, {@code stem-3} and so on. */
    NUMBER
}
