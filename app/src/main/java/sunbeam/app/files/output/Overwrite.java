package sunbeam.app.files.output;

/** What happens to a file that stands where an output is to be written. */
public enum Overwrite {
    /** It stays, and writing fails. */
    REFUSE,
    /** It is replaced at the moment the new one is complete. */
    REPLACE
}
