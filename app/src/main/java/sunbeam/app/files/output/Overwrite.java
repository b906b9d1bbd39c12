package sunbeam.app.files.output;

/** What happens to a file that stands where an output is to be written. */
public enum Overwrite {
    /** It stays, and writing fails. */
    REFUSE,
    /** It is replaced at the moment the new one is complete. */
    REPLACE,
    /** It stays, and the new one gets the first free name of {@code stem-2}, {@code stem-3} and so on. */
    NUMBER
}
