package sunbeam.precompute.table;

/** A table in the cache that cannot be used; the message names its file and what is wrong with it. */
public final class TableException extends RuntimeException {
    public TableException(String problem) {
        super(problem);
    }
}
